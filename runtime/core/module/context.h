// What the modules of one run may need at their creation, besides their parameters.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "plugins/robot/robot_description.h"

namespace runtime {

class Plugin;  // runtime/core/task/plugin.h

struct Context {
  // Outlives the modules. Of a run without a robot: a description without anything, and no name.
  const robot::RobotDescription* robot = nullptr;
  std::shared_ptr<const Plugin> task = {};  // what the task modules begin with
  uint64_t seed = 0;
};

// For modules that are made for a robot. Throws UserError, which calls the module by its name, in a
// run without one.
const robot::RobotDescription& RobotOf(const Context& context, const std::string& module);

}  // namespace runtime
