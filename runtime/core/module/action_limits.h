// Which vectors an environment takes as actions.
#pragma once

#include <Eigen/Core>

#include "runtime/core/module/port.h"

namespace runtime {

// As many elements as an action has; each lies within its limits, ends included. What lies beyond
// is cut off. Both are finite, and `low` is not above `high`.
struct ActionLimits {
  Eigen::VectorXd low;
  Eigen::VectorXd high;
};

template <>
struct TypeText<ActionLimits> {
  static constexpr const char* value = "action limits";
};

}  // namespace runtime
