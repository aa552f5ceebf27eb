#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <initializer_list>

namespace runtime {

inline Eigen::VectorXd VectorOf(std::initializer_list<double> elements) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(elements.size()));
  std::copy(elements.begin(), elements.end(), vector.begin());
  return vector;
}

}  // namespace runtime
