#pragma once

#include <string>

#include "plugins/robot/robot_description.h"

namespace runtime {

// The robot of the experiments, read once.
inline const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription humanoid =
      robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  return humanoid;
}

inline const robot::NetDescription& HumanoidNet(const std::string& name) {
  return *Humanoid().FindNet(name);
}

}  // namespace runtime
