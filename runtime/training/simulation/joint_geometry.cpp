#include "runtime/training/simulation/joint_geometry.h"

#include <cassert>
#include <cmath>

namespace runtime {
namespace {

// From the center of a link to a place, both in the zero pose.
Vector3 ArmTo(const robot::Vector3& place, const robot::Link& link) {
  return ToEigen(place.data()) - ToEigen(link.position.data());
}

// The turn that brings the child's axes to those of its parent, to first order, as ODE has it.
Vector3 TurnBack(const LinkState& parent, const LinkState& child) {
  const Matrix3 turn = child.rotation * parent.rotation.transpose();
  const Vector3 skew(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  return -skew / std::sqrt(1 + turn.trace());  // 2 sin(angle / 2)
}

class HingeGeometry : public JointGeometry {
 public:
  HingeGeometry(const robot::Joint& joint, const robot::Link& parent, const robot::Link& child)
      : parent_anchor_(ArmTo(joint.anchor, parent)),
        child_anchor_(ArmTo(joint.anchor, child)),
        axis_(ToEigen(joint.axis.data()).normalized()) {}

  FreeMotion Free() const override { return FreeTurn(); }

  Vector6 Read(const LinkState& parent, const LinkState& child, TreeJoint& joint) const override {
    joint.parent_arm = parent.rotation * parent_anchor_;
    joint.child_arm = child.rotation * child_anchor_;
    joint.axis = parent.rotation * axis_;
    const Vector3 gap = parent.position + joint.parent_arm - child.position - joint.child_arm;
    Vector3 tilt = (child.rotation * axis_).cross(joint.axis);
    tilt -= joint.axis.dot(tilt) * joint.axis;  // rounding that would turn the joint
    Vector6 way;
    way << gap, tilt;
    return way;
  }

  double Speed(const TreeJoint& joint, std::span<const Vector6> velocities) const override {
    return joint.axis.dot(velocities[joint.parent].tail<3>() - velocities[joint.child].tail<3>());
  }
  void AddImpulse(double impulse, TreeJoint& joint) const override {
    joint.load.tail<3>() -= impulse * joint.axis;
  }

 private:
  Vector3 parent_anchor_;
  Vector3 child_anchor_;
  Vector3 axis_;
};

// As in ODE the two are joined half way between their centers, wherever these have got to, and the
// axis is that of a coordinate which grows as the parent gets ahead.
class SliderGeometry : public JointGeometry {
 public:
  SliderGeometry(const robot::Joint& joint, const robot::Link& parent, const robot::Link& child)
      : to_parent_(ArmTo(parent.position, child)),
        axis_(-ToEigen(joint.axis.data()).normalized()) {}

  FreeMotion Free() const override { return FreeShift(); }

  Vector6 Read(const LinkState& parent, const LinkState& child, TreeJoint& joint) const override {
    const Vector3 between = child.position - parent.position;
    joint.parent_arm = 0.5 * between;
    joint.child_arm = -0.5 * between;
    joint.axis = parent.rotation * axis_;
    Vector3 gap = -(between + child.rotation * to_parent_);
    gap -= joint.axis.dot(gap) * joint.axis;
    Vector6 way;
    way << gap, TurnBack(parent, child);
    return way;
  }

  double Speed(const TreeJoint& joint, std::span<const Vector6> velocities) const override {
    const Vector6 parent = VelocityAt(joint.parent_arm, velocities[joint.parent]);
    const Vector6 child = VelocityAt(joint.child_arm, velocities[joint.child]);
    return joint.axis.dot(parent.head<3>() - child.head<3>());
  }
  void AddImpulse(double impulse, TreeJoint& joint) const override {
    joint.load.head<3>() -= impulse * joint.axis;
  }

 private:
  Vector3 to_parent_;  // from the child's center, in the zero pose
  Vector3 axis_;
};

class FixedGeometry : public JointGeometry {
 public:
  FixedGeometry(const robot::Link& parent, const robot::Link& child)
      : to_child_(ArmTo(child.position, parent)) {}

  FreeMotion Free() const override { return NothingFree(); }

  Vector6 Read(const LinkState& parent, const LinkState& child, TreeJoint& joint) const override {
    joint.parent_arm = parent.rotation * to_child_;
    joint.child_arm.setZero();
    Vector6 way;
    way << parent.position + joint.parent_arm - child.position, TurnBack(parent, child);
    return way;
  }

 private:
  Vector3 to_child_;
};

class BallGeometry : public JointGeometry {
 public:
  BallGeometry(const robot::Mount& mount, const robot::Link& parent, const robot::Link& child)
      : parent_anchor_(ArmTo(mount.anchor, parent)), child_anchor_(ArmTo(mount.anchor, child)) {}

  FreeMotion Free() const override { return FreeTurns(); }

  Vector6 Read(const LinkState& parent, const LinkState& child, TreeJoint& joint) const override {
    joint.parent_arm = parent.rotation * parent_anchor_;
    joint.child_arm = child.rotation * child_anchor_;
    Vector6 way;
    way << parent.position + joint.parent_arm - child.position - joint.child_arm, Vector3::Zero();
    return way;
  }

 private:
  Vector3 parent_anchor_;
  Vector3 child_anchor_;
};

std::unique_ptr<JointGeometry> GeometryOf(const robot::Joint& joint, const robot::Link& parent,
                                          const robot::Link& child) {
  switch (joint.kind) {
    case robot::JointKind::kHinge:
    case robot::JointKind::kContinuous:
      return std::make_unique<HingeGeometry>(joint, parent, child);
    case robot::JointKind::kSlider:
      return std::make_unique<SliderGeometry>(joint, parent, child);
  }
  assert(!"a kind of joint");
  return nullptr;
}

std::unique_ptr<JointGeometry> GeometryOf(const robot::Mount& mount, const robot::Link& parent,
                                          const robot::Link& child) {
  switch (mount.kind) {
    case robot::MountKind::kFixed:
      return std::make_unique<FixedGeometry>(parent, child);
    case robot::MountKind::kBall:
      return std::make_unique<BallGeometry>(mount, parent, child);
  }
  assert(!"a kind of mount");
  return nullptr;
}

}  // namespace

double JointGeometry::Speed(const TreeJoint&, std::span<const Vector6>) const { return 0; }

void JointGeometry::AddImpulse(double, TreeJoint&) const {}

std::unique_ptr<JointGeometry> MakeGeometry(const robot::RobotDescription& robot,
                                            const robot::Branch& branch) {
  const robot::Link& parent = robot.links[branch.parent];
  const robot::Link& child = robot.links[branch.child];
  return branch.joint >= 0 ? GeometryOf(robot.joints[branch.joint], parent, child)
                           : GeometryOf(robot.mounts[branch.mount], parent, child);
}

}  // namespace runtime
