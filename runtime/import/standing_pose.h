#pragma once

#include <optional>

#include "plugins/robot/robot_description.h"

namespace runtime {

// A pose in which the robot, told to hold it, stands for a second, at least half as high as `pose`
// has it on the ground: as high as can be found near the angles of `pose`, with left and right
// alike where the DoF configuration `symmetric` says which joints these are. Nothing where the
// search ends without one. The same every time.
std::optional<robot::Pose> FindStandingPose(const robot::RobotDescription& robot,
                                            const robot::Pose& pose);

// The pose above the world's origin, as high as it must be to touch the ground; a fixed base is
// only lifted out of it.
robot::Pose PutOnGround(const robot::RobotDescription& robot, robot::Pose pose);

}  // namespace runtime
