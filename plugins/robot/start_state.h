// How a robot begins an episode.
#pragma once

#include <algorithm>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace robot {

struct StartState {
  Pose pose;
  // The pose that this one was made of: the robot touches the ground as it does there, and is as
  // much above that as its base has been lifted.
  Pose from;
  std::vector<double> joint_velocities;  // one for each joint [rad/s]
  Vector3 velocity{};                    // of the base, in the world [m/s]
  Vector3 angular_velocity{};            // of the whole robot, in the world [rad/s]

  bool IsAtRest() const {
    const auto is_zero = [](double speed) { return speed == 0; };
    return std::ranges::all_of(joint_velocities, is_zero) &&
           std::ranges::all_of(velocity, is_zero) && std::ranges::all_of(angular_velocity, is_zero);
  }

  bool operator==(const StartState&) const = default;
};

// At rest in a pose.
inline StartState RestIn(const Pose& pose) {
  return {pose, pose, std::vector<double>(pose.joint_angles.size()), {}, {}};
}

}  // namespace robot
