#pragma once

#include <Eigen/Core>

#include "plugins/robot/robot_description.h"

namespace runtime {

// Between which angles a robot's joints can be [rad].
struct JointStops {
  JointStops() = default;
  explicit JointStops(const robot::RobotDescription& robot)
      : low(static_cast<Eigen::Index>(robot.joints.size())), high(low.size()) {
    for (Eigen::Index i = 0; i < low.size(); ++i) {
      low[i] = robot.joints[static_cast<size_t>(i)].low;
      high[i] = robot.joints[static_cast<size_t>(i)].high;
    }
  }

  // `targets` has an element for each joint; those beyond a stop end there.
  void Limit(Eigen::VectorXd& targets) const { targets = targets.cwiseMax(low).cwiseMin(high); }

  Eigen::VectorXd low, high;
};

}  // namespace runtime
