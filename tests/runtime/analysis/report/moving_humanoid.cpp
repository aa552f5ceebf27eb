#include "tests/runtime/analysis/report/moving_humanoid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "runtime/training/simulation/link_frames.h"

namespace runtime {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

// Joint angles at `phase` of the gait [rad]; joints that are not named rest.
std::map<std::string, double> GaitAngles(double phase) {
  const double swing = std::sin(phase);
  const double lift = std::max(0., std::cos(phase));
  const double other_lift = std::max(0., -std::cos(phase));
  return {{"neck_yaw", 0.25 * swing},
          {"left_shoulder_pitch", 1.75 + 0.55 * swing},
          {"left_elbow_pitch", 0.2 + 0.5 * lift},
          {"left_hip_pitch", 1.15 - 0.45 * swing},
          {"left_knee_pitch", -1.1 - 0.6 * other_lift},
          {"left_ankle_pitch", -0.6},
          {"right_shoulder_pitch", 1.75 - 0.55 * swing},
          {"right_elbow_pitch", 0.2 + 0.5 * other_lift},
          {"right_hip_pitch", 1.15 + 0.45 * swing},
          {"right_knee_pitch", -1.1 - 0.6 * lift},
          {"right_ankle_pitch", -0.6}};
}

// On all fours, the trunk swaying with the steps.
robot::Pose CrawlingPose(const robot::RobotDescription& robot, double time, double speed) {
  const double phase = 2 * std::numbers::pi * time / 1.1;
  const Eigen::Quaterniond turn =
      AngleAxisd(0.12 * std::sin(phase), Vector3d::UnitZ()) * AngleAxisd(1.2, Vector3d::UnitY());
  robot::Pose pose;
  pose.position = {speed * time, 0.04 * std::sin(0.5 * time), 0};
  pose.orientation = {turn.w(), turn.x(), turn.y(), turn.z()};
  const std::map<std::string, double> angles = GaitAngles(phase);
  for (const robot::Joint& joint : robot.joints) {
    const auto angle = angles.find(joint.name);
    pose.joint_angles.push_back(angle == angles.end() ? 0 : angle->second);
  }
  return pose;
}

// The height of the lowest point of a link.
double LowestPoint(const robot::LinkShape& shape, const LinkFrame& frame) {
  const Vector3d down = frame.orientation.conjugate() * Vector3d::UnitZ();  // seen from the link
  const double center = frame.position.z();
  if (shape.kind == robot::ShapeKind::kBox) {
    return center - 0.5 * down.cwiseAbs().dot(Vector3d(shape.size.data()));
  }
  const double straight = std::max(0., shape.length / 2 - shape.radius);
  return center - shape.radius - straight * std::abs(down[shape.axis]);
}

}  // namespace

std::vector<float> CrawlingPoses(const robot::RobotDescription& robot, double duration,
                                 double interval, double speed) {
  std::vector<float> poses;
  const int count = static_cast<int>(std::lround(duration / interval)) + 1;
  for (int i = 0; i < count; ++i) {
    const std::vector<LinkFrame> frames =
        LinkFrames(robot, CrawlingPose(robot, i * interval, speed));
    double lowest = 1;
    for (size_t link = 0; link < frames.size(); ++link) {
      lowest = std::min(lowest, LowestPoint(robot.links[link].shape, frames[link]));
    }
    for (const LinkFrame& frame : frames) {
      const Vector3d& p = frame.position;
      const Eigen::Quaterniond& q = frame.orientation;
      for (const double value : {p.x(), p.y(), p.z() - lowest, q.w(), q.x(), q.y(), q.z()}) {
        poses.push_back(static_cast<float>(value));
      }
    }
  }
  return poses;
}

}  // namespace runtime
