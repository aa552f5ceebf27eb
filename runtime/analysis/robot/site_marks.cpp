#include "runtime/analysis/robot/site_marks.h"

#include "runtime/analysis/robot/axis_colors.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

constexpr double kAxisLength = 0.04;  // of an axis, in parts of the robot
constexpr double kAxisWidth = 0.008;  // of its line, in parts of the picture

}  // namespace

std::vector<Stroke> SiteMarks(const robot::RobotDescription& robot,
                              const std::vector<LinkFrame>& frames, double size) {
  std::vector<Stroke> strokes;
  for (const robot::Site& site : robot.sites) {
    const LinkFrame& link = frames[static_cast<size_t>(site.link)];
    const robot::Vector3 arm = robot.ArmOf(site);
    const robot::Quaternion& q = site.orientation;
    const Vector3d place = link.position + link.orientation * Vector3d(arm[0], arm[1], arm[2]);
    const Eigen::Quaterniond turn = link.orientation * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d tip = place + kAxisLength * size * (turn * Vector3d::Unit(axis));
      strokes.push_back({place, tip, kAxisWidth, kAxisColors[static_cast<size_t>(axis)]});
    }
  }
  return strokes;
}

}  // namespace runtime
