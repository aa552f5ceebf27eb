#pragma once

#include <Eigen/Core>

#include "plugins/robot/robot_description.h"

namespace runtime {

// From the coordinates of a DoF configuration to the targets of all joints: q = F a [rad].
class DofMapping {
 public:
  DofMapping() = default;
  DofMapping(const robot::DofConfiguration& dof, int joints);

  int joints() const { return static_cast<int>(factors_.rows()); }
  const Eigen::MatrixXd& factors() const { return factors_; }  // F: joints x coordinates

  // `targets` has one element for each joint; those without a coupling become 0.
  void Apply(const Eigen::VectorXd& coordinates, Eigen::VectorXd& targets) const {
    targets.noalias() = factors_ * coordinates;
  }

 private:
  Eigen::MatrixXd factors_;
};

}  // namespace runtime
