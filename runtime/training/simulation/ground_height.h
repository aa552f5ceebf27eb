// How high above the ground a robot is.
#pragma once

#include "plugins/robot/robot_description.h"
#include "plugins/robot/start_state.h"

namespace runtime {

// The height of the lowest point of any link [m].
double LowestPoint(const robot::RobotDescription& robot, const robot::Pose& pose);

// The pose of a start at the right height: it touches the ground as the pose does that it was made
// of, and is above that by as much as its base was lifted, never below. A fixed base stays where
// it is.
robot::Pose OnGround(const robot::RobotDescription& robot, const robot::StartState& start);

}  // namespace runtime
