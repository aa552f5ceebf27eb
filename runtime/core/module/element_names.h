#pragma once

#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/core/module/observations.h"

namespace runtime {

// A name for each number of the value, in their order: "height"; "velocity.x";
// "base.orientation.w"; "base.rotation[0, 2]"; of arrays "joint.velocity[neck_yaw]",
// "contact[feet][0]", "link.velocity[head].z". A value that is called by an expression such as `a -
// b` is in parentheses: "(a - b)[neck_yaw]".
std::vector<std::string> ElementNames(const ObservedValue& value,
                                      const robot::RobotDescription& robot);

}  // namespace runtime
