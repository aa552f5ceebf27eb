// What the modules of one run may need at their creation, besides their parameters.
#pragma once

#include <cstdint>
#include <filesystem>

#include "plugins/robot/robot_description.h"

namespace runtime {

struct Context {
  const robot::RobotDescription* robot = nullptr;  // outlives the modules
  std::filesystem::path task_plugin;               // shared object of the task to run
  uint64_t seed = 0;
};

}  // namespace runtime
