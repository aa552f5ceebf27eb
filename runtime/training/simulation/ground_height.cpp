#include "runtime/training/simulation/ground_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  // The heights of the ends of the link's own axes.
  const Eigen::RowVector3d heights = link.toRotationMatrix().row(2).cwiseAbs();
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return heights.dot(Eigen::Map<const Eigen::Vector3d>(shape.size.data())) / 2;
    case robot::ShapeKind::kCapsule:
      return heights[shape.axis] * (shape.length / 2 - shape.radius) + shape.radius;
    case robot::ShapeKind::kCylinder: {
      const double tilt = std::min(1., heights[shape.axis]);
      return tilt * shape.length / 2 + shape.radius * std::sqrt(1 - tilt * tilt);
    }
    case robot::ShapeKind::kSphere:
      return shape.radius;
    case robot::ShapeKind::kConvex:
      break;
  }
  double reach = -std::numeric_limits<double>::infinity();
  for (const robot::Vector3& point : shape.points)
    reach = std::max(reach, -(link * Eigen::Vector3d(point.data())).z());
  return reach;
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
