// The DoF configurations of a robot, as parameters of modules name them.
#pragma once

#include <string>

#include "plugins/robot/robot_description.h"

namespace runtime {

// Throws UserError, which begins with the parameter's name and shows the nearest configuration,
// where the robot has none of this name.
const robot::DofConfiguration& FindDof(const robot::RobotDescription& robot,
                                       const std::string& name, const std::string& parameter);

// The same; and the name of a group of joints, or "all", those with a motor, is a configuration
// with a coordinate for each of these joints.
robot::DofConfiguration FindDofOrJoints(const robot::RobotDescription& robot,
                                        const std::string& name, const std::string& parameter);

// The same for what moves one side of the robot: "all" are the joints of one side that have a
// motor, and a counterpart on the other (joint_mirror.h). Throws UserError also where there are
// none.
robot::DofConfiguration FindDofOfOneSide(const robot::RobotDescription& robot,
                                         const std::string& name, const std::string& parameter);

}  // namespace runtime
