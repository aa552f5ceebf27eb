#pragma once

#include "plugins/robot/robot_description.h"

namespace runtime {

// How many times as large as the humanoid of the paper a robot is, to a hundredth, and never less
// than that: by the diagonal of the box around its links in the pose that episodes start from. What
// holds a robot whose base is fixed (a rail, a column) does not count. 1 for the humanoid itself.
double ScaleOf(const robot::RobotDescription& robot);

}  // namespace runtime
