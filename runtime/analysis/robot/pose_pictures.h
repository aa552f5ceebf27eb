// Pictures of a robot's poses.
#pragma once

#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/robot/held_pose.h"

namespace runtime {

// A strip (runtime/analysis/picture/snapshot_strip.h) of two pictures for each pose: as it starts,
// with its joints (joint_marks.h), and as it ends. `height`: of the strip [px]. At least one pose.
std::string PosePictures(const robot::RobotDescription& robot, const std::vector<HeldPose>& poses,
                         int height);

}  // namespace runtime
