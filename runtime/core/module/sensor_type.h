#pragma once

#include <cstddef>
#include <string_view>

#include "plugins/robot/robot_description.h"

namespace runtime {

// How many elements a sensor of the type has, as `taskc` writes it: 3 for "vec3", 12 for
// "real[joint]" of a robot with 12 joints. 0: there is no such type.
size_t ElementsOfType(std::string_view type, const robot::RobotDescription& robot);

}  // namespace runtime
