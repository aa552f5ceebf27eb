// What of a robot a picture of its motion is about.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"

namespace runtime {

// Indices of links, ascending, at least one: mostly all. Where the base stays where it is, which is
// what carries the robot then, only the links that turn at some time and those that touch them, or
// touch what touches them: a rail high above a robot that is led in a plane is not what one wants
// to see, but a rail with a cart on it is. The first of them is the one whose way is followed.
// `links`: those of the motion, with their shapes.
std::vector<int> SubjectOf(const Motion& motion, const std::vector<robot::Link>& links);

}  // namespace runtime
