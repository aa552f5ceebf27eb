// A normalized Gaussian network: smooth features that divide a space among their centers.
//
// Unit k answers to the point x with
//
//   phi_k(x) = G_k(x) / sum_m G_m(x),   G_k(x) = exp(-1/2 sum_i ((x_i - mu_ki) / sigma_i)^2)
//
// All units share one diagonal covariance, so the determinant of the general form cancels.
// Dimensions of a state that a net ignores (in other implementations: center 0 and a huge
// deviation, the same in every unit) cancel as well, exactly; a net therefore knows only the
// dimensions that it uses.
#pragma once

#include <Eigen/Core>

#include "runtime/core/module/port.h"
#include "runtime/training/learning/norm.h"

namespace runtime {

class GaussianNet {
 public:
  // A dimension with a deviation of this size or more does not count as one that a unit has a width
  // in (see neighbor_distances).
  static constexpr double kInfiniteDeviation = 500;

  // No units: a net that is yet to be made.
  GaussianNet() = default;

  // `centers`: one row for each unit, one column for each dimension. `deviations`: sigma for each
  // dimension, positive. `norm` measures the distances between the centers.
  GaussianNet(Eigen::MatrixXd centers, Eigen::VectorXd deviations, Norm norm);

  int units() const { return static_cast<int>(centers_.rows()); }
  int dimensions() const { return static_cast<int>(centers_.cols()); }
  const Eigen::MatrixXd& centers() const { return centers_; }
  const Eigen::VectorXd& deviations() const { return deviations_; }

  // d_k: the distance from unit k's center to the nearest other one, or the largest finite
  // deviation, whichever is more; kInfiniteDeviation if no deviation is finite.
  const Eigen::VectorXd& neighbor_distances() const { return neighbor_distances_; }

  // phi at `point` (as many elements as dimensions). `features` has as many elements as units.
  // Allocates nothing.
  void Evaluate(const Eigen::Ref<const Eigen::VectorXd>& point, Eigen::VectorXd& features) const;

 private:
  Eigen::MatrixXd centers_;
  Eigen::VectorXd deviations_;
  Eigen::VectorXd exponent_factors_;  // -1 / (2 sigma_i^2)
  Eigen::VectorXd neighbor_distances_;
};

template <>
struct TypeText<GaussianNet> {
  static constexpr const char* value = "Gaussian network";
};

}  // namespace runtime
