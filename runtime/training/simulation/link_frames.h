// Where the links of a robot are in a pose.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

// The frame of a link lies in its center of mass and is parallel to the world's in the zero pose.
struct LinkFrame {
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;  // link -> world
};

// One frame for each link. The robot is turned as a whole about its base, moved to the pose's
// position, and then each joint moves all that hangs on it.
std::vector<LinkFrame> LinkFrames(const robot::RobotDescription& robot, const robot::Pose& pose);

}  // namespace runtime
