// The DoF configurations of a robot, as parameters of modules name them.
#pragma once

#include <string>

#include "plugins/robot/robot_description.h"

namespace runtime {

// Throws UserError, which begins with the parameter's name and shows the nearest configuration,
// where the robot has none of this name.
const robot::DofConfiguration& FindDof(const robot::RobotDescription& robot,
                                       const std::string& name, const std::string& parameter);

// The same, and "all" is one with a coordinate for each joint.
robot::DofConfiguration FindDofOrAll(const robot::RobotDescription& robot, const std::string& name,
                                     const std::string& parameter);

}  // namespace runtime
