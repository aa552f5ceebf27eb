// A motion of the coordinates of a robot as a function of time, chosen by a vector of parameters,
// each in [-1, 1]. With c and h the center and half the width of a coordinate's range, and
//
//   f = lowest (highest / lowest)^((1 + u_f) / 2)                                         [Hz]
//
// the coordinate is
//
//   periodic   c + h (u + sum_k (a_k sin(2 pi k f t) + b_k cos(2 pi k f t)) / k)
//   one_shot   at t = i / (K f) for i = 1 .. K:  c + h u_i; from where it rests at t = 0 a
//              Catmull-Rom spline goes through these knots, begins and ends with rate 0, and stays
//              at the last one
//
// So u is an offset, a_k and b_k are the amplitude and phase of harmonic k, and 1 / f is how long a
// period, or the whole motion, lasts. The parameters' order: u_f, then those of each coordinate: u,
// a_1, b_1, a_2, ... or u_1 .. u_K.
#pragma once

#include <Eigen/Core>
#include <string>

namespace runtime {

class ParametricMotion {
 public:
  static constexpr const char* kPeriodic = "periodic";
  static constexpr const char* kOneShot = "one_shot";

  struct Settings {
    std::string kind = kPeriodic;
    int harmonics = 2;
    int knots = 6;
    double lowest_frequency = 0.5;  // [Hz]
    double highest_frequency = 5;
  };

  ParametricMotion() = default;
  // `centers` and `halves`: of the coordinates' ranges.
  ParametricMotion(const Settings& settings, Eigen::VectorXd centers, Eigen::VectorXd halves);

  int coordinates() const { return static_cast<int>(centers_.size()); }
  int size() const { return 1 + coordinates() * per_coordinate(); }  // of the parameters

  // The parameters of no motion: the coordinates stay at `rest`, or at the nearest place that they
  // can reach.
  Eigen::VectorXd Standstill(const Eigen::VectorXd& rest) const;

  // Takes the motion with these parameters, of coordinates that are at `rest` at first. Allocates
  // nothing.
  void Take(const Eigen::VectorXd& parameters, const Eigen::VectorXd& rest);
  double frequency() const { return frequency_; }  // f of that motion
  // The coefficients of that motion, each a column of the coordinates' [coordinates x columns]: of
  // 1, sin(2 pi f t), cos(2 pi f t), sin(4 pi f t), ...; or the rest and the knots.
  Eigen::MatrixXd Columns() const;
  // Its coordinates at `time` [s]. Allocates nothing.
  const Eigen::VectorXd& At(double time);

  bool is_periodic() const { return settings_.kind == kPeriodic; }

 private:
  int per_coordinate() const {
    return is_periodic() ? 1 + 2 * settings_.harmonics : settings_.knots;
  }
  void FillBasis(double time);

  Settings settings_;
  Eigen::VectorXd centers_, halves_;
  Eigen::VectorXd rest_;  // from -1 to 1 like the parameters
  double frequency_ = 0;
  Eigen::MatrixXd shape_;  // the parameters of each coordinate as a column

  // What the parameters are multiplied with, and rest_.
  Eigen::VectorXd basis_;
  double rest_share_ = 0;
  Eigen::VectorXd values_;
};

}  // namespace runtime
