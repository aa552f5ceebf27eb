#include "runtime/training/simulation/link_frames.h"

#include <cassert>

namespace runtime {
namespace {

Eigen::Vector3d ToEigen(const robot::Vector3& v) { return {v[0], v[1], v[2]}; }

// Where a rigid part takes the points of the zero pose.
struct Motion {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return rotation * point + translation;
  }
};

// The motions of a joint's child, given that of its parent.

Motion Shifted(const Motion& parent, const robot::Joint& joint, double angle) {
  Motion child = parent;
  child.translation += parent.rotation * (joint.radius * angle * ToEigen(joint.axis));
  return child;
}

Motion Turned(const Motion& parent, const robot::Joint& joint, double angle) {
  if (angle == 0) return parent;  // the poses without bent joints stay free of rounding
  const Eigen::Vector3d anchor = ToEigen(joint.anchor);
  Motion child;
  child.rotation =
      parent.rotation * Eigen::Quaterniond(Eigen::AngleAxisd(-angle, ToEigen(joint.axis)));
  child.translation = parent * anchor - child.rotation * anchor;
  return child;
}

Motion Moved(const Motion& parent, const robot::Joint& joint, double angle) {
  switch (joint.kind) {
    case robot::JointKind::kHinge:
    case robot::JointKind::kContinuous:
      return Turned(parent, joint, angle);
    case robot::JointKind::kSlider:
      return Shifted(parent, joint, angle);
  }
  assert(!"a kind of joint");
  return parent;
}

}  // namespace

std::vector<LinkFrame> LinkFrames(const robot::RobotDescription& robot, const robot::Pose& pose) {
  std::vector<Motion> motions(robot.links.size());
  const robot::Quaternion& q = pose.orientation;
  motions[0] = {Eigen::Quaterniond(q[0], q[1], q[2], q[3]), ToEigen(pose.position)};
  for (const robot::Branch& branch : robot.Branches()) {
    const Motion& parent = motions[branch.parent];
    motions[branch.child] = branch.joint < 0 ? parent
                                             : Moved(parent, robot.joints[branch.joint],
                                                     pose.joint_angles[branch.joint]);
  }
  std::vector<LinkFrame> frames;
  for (size_t i = 0; i < robot.links.size(); ++i) {
    frames.push_back({motions[i] * ToEigen(robot.links[i].position), motions[i].rotation});
  }
  return frames;
}

}  // namespace runtime
