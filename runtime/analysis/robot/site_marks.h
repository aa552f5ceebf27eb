// Where a robot's sites are and how they are turned, as lines over a picture.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/picture/strokes.h"
#include "runtime/training/simulation/link_frames.h"

namespace runtime {

// Of each site its axes, from where it is: x in red, y in green, z in blue.
//
// `frames`: of the links. `size`: of the robot, to which that of the marks is fitted [m].
std::vector<Stroke> SiteMarks(const robot::RobotDescription& robot,
                              const std::vector<LinkFrame>& frames, double size);

}  // namespace runtime
