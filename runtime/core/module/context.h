// What the modules of one run may need at their creation, besides their parameters.
#pragma once

#include <cstdint>
#include <memory>

#include "plugins/robot/robot_description.h"

namespace runtime {

class Plugin;  // runtime/core/task/plugin.h

struct Context {
  const robot::RobotDescription* robot = nullptr;  // outlives the modules
  std::shared_ptr<const Plugin> task = {};         // what the task modules begin with
  uint64_t seed = 0;
};

}  // namespace runtime
