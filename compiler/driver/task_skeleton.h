// The text of a task to begin with.
#pragma once

#include <string>

#include "plugins/robot/robot_description.h"

namespace compiler {

// With comments that list what the robot offers. `robot`: null for a task that brings its own
// sensors.
std::string TaskSkeleton(const std::string& name, const robot::RobotDescription* robot);

}  // namespace compiler
