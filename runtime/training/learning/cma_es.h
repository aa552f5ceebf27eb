// CMA-ES, the evolution strategy with covariance matrix adaptation: minimizes a function of which
// only values are known, and of these only the order matters. Formulas and default settings are
// those of N. Hansen, "The CMA Evolution Strategy: A Tutorial" (arXiv:1604.00772), figure 6 and
// table 1, negative weights included.
//
//   x_k = m + sigma y_k,  y_k = B D z_k,  z_k ~ N(0, I)         a generation: k = 1 .. lambda
//   m <- m + sigma <y>                                          <y>: weighted mean of the best half
//   p_s <- (1 - c_s) p_s + sqrt(c_s (2 - c_s) mu_eff) B <z>
//   sigma <- sigma exp(c_s / d_s (|p_s| / E|N(0, I)| - 1))
//   p_c <- (1 - c_c) p_c + h sqrt(c_c (2 - c_c) mu_eff) <y>
//   C <- (1 + c_1 (1 - h) c_c (2 - c_c) - c_1 - c_mu sum w) C + c_1 p_c p_c' + c_mu sum w_k y_k
//   y_k' C = B D^2 B'
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "runtime/training/learning/random.h"

namespace runtime {

// The settings that follow from the number of dimensions and that of candidates (table 1).
struct CmaEsSettings {
  CmaEsSettings() = default;
  CmaEsSettings(int dimensions, int population);

  Eigen::VectorXd
      weights;      // w, one for each candidate, the best first; those of the worse half < 0
  int parents = 0;  // mu: how many of them are greater than 0
  double mu_eff = 0;
  double c_sigma = 0, d_sigma = 0;
  double c_c = 0, c_1 = 0, c_mu = 0;
  double expected_length = 0;  // E|N(0, I)|
};

class CmaEs {
 public:
  // 4 + 3 ln n, rounded down.
  static int DefaultPopulation(int dimensions);

  CmaEs() = default;
  // Begins with candidates around `mean`, `sigma` > 0 from it along each axis. `population`: of a
  // generation, at least 2.
  CmaEs(const Eigen::VectorXd& mean, double sigma, int population);

  int dimensions() const { return static_cast<int>(mean_.size()); }
  int population() const { return static_cast<int>(costs_.size()); }
  int64_t generation() const { return generation_; }  // how many are over
  double sigma() const { return sigma_; }
  const Eigen::VectorXd& mean() const { return mean_; }
  // The standard deviation along the widest axis of the candidates, and along the narrowest.
  double widest() const { return sigma_ * solver_axes_.maxCoeff(); }
  double narrowest() const { return sigma_ * solver_axes_.minCoeff(); }

  // Draws the next candidate of this generation. Asked again before it is told what that one cost,
  // it draws another in its place.
  const Eigen::VectorXd& Ask(Random& random);
  // What Ask() would draw, as long as the generation is the same.
  Eigen::VectorXd Foresee(Random& random) const;
  // How many candidates of this generation are still to be told of.
  int left() const { return population() - told_ % population(); }
  // What the candidate cost that was asked for last; infinite or not a number: more than any other.
  // Returns whether the generation is over with it. Allocates nothing.
  bool Tell(double cost);
  // Costs of this generation, in the order of asking: those told so far, or after the last one all.
  auto costs() const { return costs_.head(told_); }
  // The generation begins again: what it was told is forgotten.
  void ForgetGeneration() { told_ = 0; }

  // All that the next candidates depend on, but for the random numbers.
  void Save(std::ostream& out) const;
  // The stream has failed where it holds something else; then nothing has changed.
  void Load(std::istream& in);

 private:
  struct Candidate {
    Eigen::VectorXd drawn, step, rotated, place;  // z, D z, B D z, x
  };

  void Allocate();
  void Decompose();
  void Draw(Random& random, Candidate& candidate) const;
  void SortCandidates();
  void MoveMean();
  void AdaptSigma();
  void AdaptCovariance();
  bool PathIsLong() const;
  void FinishGeneration();

  CmaEsSettings settings_;
  Eigen::VectorXd mean_;        // m
  double sigma_ = 0;            // step size
  Eigen::MatrixXd covariance_;  // C; its lower triangle
  Eigen::VectorXd path_sigma_, path_c_;
  int64_t generation_ = 0;
  Eigen::MatrixXd drawn_;  // z_k as columns
  Eigen::VectorXd costs_;
  int told_ = 0;  // as many of these candidates have been

  // What follows from the above.
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver_;  // of C
  Eigen::VectorXd solver_axes_;                            // the diagonal of D

  // Scratch.
  std::vector<int> order_;
  Candidate candidate_;
  Eigen::VectorXd mean_drawn_, mean_step_, rotated_, step_;
};

}  // namespace runtime
