#include "runtime/analysis/behavior/robot_scale.h"

#include <algorithm>
#include <cmath>

#include "plugins/robot/shape_extent.h"
#include "runtime/training/simulation/link_frames.h"

namespace runtime {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kHumanoid = 0.39;  // [m]

// From the shape's center to each side of the box around it, along the world's axes.
Vector3d HalfExtents(const robot::LinkShape& shape, const Quaterniond& orientation) {
  Vector3d extents;
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = orientation.conjugate() * Vector3d::Unit(k);
    extents[k] = std::max(robot::ReachAlong(shape, {axis[0], axis[1], axis[2]}),
                          robot::ReachAlong(shape, {-axis[0], -axis[1], -axis[2]}));
  }
  return extents;
}

}  // namespace

double ScaleOf(const robot::RobotDescription& robot) {
  const std::vector<LinkFrame> frames = LinkFrames(robot, robot.poses.front());
  const size_t first = robot.has_fixed_base && frames.size() > 1 ? 1 : 0;
  Vector3d low = Vector3d::Constant(robot::kUnlimited);
  Vector3d high = -low;
  for (size_t i = first; i < frames.size(); ++i) {
    const robot::LinkShape& shape = robot.links[i].shape;
    const auto& [w, x, y, z] = shape.orientation;
    const Vector3d center =
        frames[i].position + frames[i].orientation * Vector3d(shape.position.data());
    const Vector3d extents = HalfExtents(shape, frames[i].orientation * Quaterniond(w, x, y, z));
    low = low.cwiseMin(center - extents);
    high = high.cwiseMax(center + extents);
  }
  const double hundredths = std::round(100 * (high - low).norm() / kHumanoid);
  return std::max(1., hundredths) / 100;
}

}  // namespace runtime
