#pragma once

#include <Eigen/Core>

namespace runtime {

// How long a vector is: the root of the sum of squares, or the largest absolute element.
enum class Norm { kEuclidean, kMax };

// The choice that modules offer as the parameter `max_norm`.
inline Norm NormFrom(bool max_norm) { return max_norm ? Norm::kMax : Norm::kEuclidean; }

// `vector` has at least one element.
template <class Vector>
double Length(const Eigen::MatrixBase<Vector>& vector, Norm norm) {
  return norm == Norm::kMax ? vector.template lpNorm<Eigen::Infinity>() : vector.norm();
}

}  // namespace runtime
