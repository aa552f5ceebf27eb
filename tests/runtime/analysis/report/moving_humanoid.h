// Made-up motions of the real robot's links, for pages that need something to show.
#pragma once

#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

// A crawl along x for `duration` seconds at `speed` m/s: [frame][link][x y z qw qx qy qz], a frame
// each `interval` seconds. The lowest point of the robot is always on the floor.
std::vector<float> CrawlingPoses(const robot::RobotDescription& robot, double duration,
                                 double interval, double speed);

}  // namespace runtime
