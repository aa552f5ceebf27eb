#include "runtime/training/simulation/ground_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/robot/shape_extent.h"
#include "runtime/training/simulation/link_frames.h"

namespace runtime {
namespace {

// How far below its link's center a shape reaches.
double ReachDown(const robot::LinkShape& shape, const Eigen::Quaterniond& link) {
  if (shape.IsMoved()) {
    const auto& [w, x, y, z] = shape.orientation;
    robot::LinkShape centered = shape;
    centered.position = {};
    centered.orientation = {1, 0, 0, 0};
    return ReachDown(centered, link * Eigen::Quaterniond(w, x, y, z)) -
           (link * Eigen::Vector3d(shape.position.data())).z();
  }
  const Eigen::RowVector3d up = link.toRotationMatrix().row(2);  // in the link's frame
  return robot::ReachAlong(shape, {-up[0], -up[1], -up[2]});
}

}  // namespace

double LowestPoint(const robot::RobotDescription& robot, const robot::Pose& pose) {
  const std::vector<LinkFrame> frames = LinkFrames(robot, pose);
  double lowest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < frames.size(); ++i) {
    const double reach = ReachDown(robot.links[i].shape, frames[i].orientation);
    lowest = std::min(lowest, frames[i].position.z() - reach);
  }
  return lowest;
}

robot::Pose OnGround(const robot::RobotDescription& robot, const robot::StartState& start) {
  if (robot.has_fixed_base) return start.pose;
  const double lift = std::max(start.pose.position[2] - start.from.position[2], 0.0);
  const double wanted = LowestPoint(robot, start.from) + lift;
  robot::Pose pose = start.pose;
  pose.position[2] += wanted - LowestPoint(robot, start.pose);
  return pose;
}

}  // namespace runtime
