// Minimizes a function on the box [-1, 1]^n, of which only values are known: CMA-ES (cma_es.h) that
// starts again, with more candidates, where a search has come to its end (IPOP: Auger and Hansen,
// "A Restart CMA Evolution Strategy With Increasing Population Size", 2005).
//
// CMA-ES itself knows no bounds. It searches all of R^n, and each coordinate x of a candidate is
// folded into the box as pycma's BoundTransform does: it is itself where |x| <= 0.9, a parabola
// bends it to meet 1 with slope 0 at |x| = 1.1, and beyond it goes back, with a period of 4.4.
#pragma once

#include <Eigen/Core>
#include <iosfwd>

#include "runtime/training/learning/cma_es.h"
#include "runtime/training/learning/cma_es_end.h"
#include "runtime/training/learning/random.h"

namespace runtime {

// The place in [-1, 1] that a coordinate is folded to.
double FoldedIntoBox(double x);
// A coordinate that is folded to `place`; of a place outside, to the nearest one inside.
double UnfoldedFromBox(double place);

class BoxSearch {
 public:
  struct Settings {
    int population = 0;       // of the first search; 0: CmaEs::DefaultPopulation()
    double sigma = 0.3;       // first step size
    double growth = 2;        // of the population with each restart, at least 1
    double least_step = 0.0;  // where candidates lie nearer to each other, the search is at its end
  };

  BoxSearch() = default;
  // Begins at `start`, a place in the box.
  BoxSearch(const Eigen::VectorXd& start, const Settings& settings);

  int dimensions() const { return search_.dimensions(); }
  // Of the search that runs now.
  int population() const { return search_.population(); }
  double sigma() const { return search_.sigma(); }
  int64_t generation() const { return generations_before_ + search_.generation(); }  // of all
  int restarts() const { return restarts_; }
  // The place in the box that stands for the middle of the candidates.
  const Eigen::VectorXd& middle() const { return middle_; }

  // The next candidate, a place in the box, until it is told what that costs. A search that has
  // come to its end is followed by another, from somewhere in the box.
  const Eigen::VectorXd& Ask(const Settings& settings, Random& random);
  // The same, for those that are told of before it; the search stays as it is.
  Eigen::VectorXd Foresee(Random& random) const;
  // How many candidates from the next one on can be foreseen; 0 where Ask() starts another search.
  int foreseen(const Settings& settings) const;
  void Tell(double cost);
  // The costs told so far are not those of the function any more: this generation begins again.
  void ForgetCosts();

  void Save(std::ostream& out) const;
  // The stream has failed where it holds something else; then nothing has changed.
  void Load(std::istream& in);

 private:
  void Begin(const Eigen::VectorXd& start, double sigma, int population);
  bool IsAtEnd(const Settings& settings) const;
  void Restart(const Settings& settings, Random& random);
  void FindMiddle();

  CmaEs search_;
  CmaEsEnd end_;
  double first_sigma_ = 0;
  int restarts_ = 0;
  int64_t generations_before_ = 0;  // of the searches that are over
  Eigen::VectorXd middle_;          // follows from the search
  Eigen::VectorXd candidate_;       // scratch
};

}  // namespace runtime
