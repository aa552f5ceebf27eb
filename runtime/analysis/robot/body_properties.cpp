#include "runtime/analysis/robot/body_properties.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/analysis/picture/shapes.h"
#include "runtime/core/shape/convex_hull.h"
#include "runtime/training/simulation/spatial.h"
#include "runtime/training/simulation/world.h"

namespace runtime {
namespace {

double VolumeOf(const robot::LinkShape& shape) {
  using std::numbers::pi;
  const double disk = pi * shape.radius * shape.radius;
  const double ball = 4. / 3 * disk * shape.radius;
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return shape.size[0] * shape.size[1] * shape.size[2];
    case robot::ShapeKind::kCapsule:
      return disk * (shape.length - 2 * shape.radius) + ball;
    case robot::ShapeKind::kCylinder:
      return disk * shape.length;
    case robot::ShapeKind::kSphere:
      return ball;
    case robot::ShapeKind::kConvex:
      break;
  }
  return MassOf(HullOf(shape.points)).volume;
}

// All angles 0, the base at the origin.
robot::Pose ZeroPose(const robot::RobotDescription& robot) {
  return {.name = {}, .joint_angles = std::vector<double>(robot.joints.size())};
}

Matrix3 InertiaIn(const dMass& mass) {
  Matrix3 inertia;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) inertia(row, column) = mass.I[4 * row + column];
  }
  return inertia;
}

class Masses {
 public:
  explicit Masses(const robot::RobotDescription& robot) : robot_(robot) {
    const World world(robot, kProfiles.front(), ZeroPose(robot));
    for (int i = 0; i < world.body().link_count(); ++i) {
      dMass mass;
      dBodyGetMass(world.body().body(i), &mass);
      inertias_.push_back(InertiaIn(mass));
    }
  }

  Vector3 PrincipalOf(size_t link) const {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertias_[link]).eigenvalues();
  }

  // Of all that moves with the joint; see JointProperties.
  double InertiaAbout(const robot::Joint& joint) const {
    const Vector6 way = WayOf(joint);
    const std::vector<bool> moves = BelowOf(joint.child);
    Matrix6 below = Matrix6::Zero();
    Matrix6 all = Matrix6::Zero();
    for (size_t i = 0; i < robot_.links.size(); ++i) {
      const Matrix6 own = AtBase(i);
      all += own;
      if (moves[i]) below += own;
    }
    const Vector6 push = below * way;
    const double locked = way.dot(push);
    if (robot_.has_fixed_base) return locked;
    return locked - push.dot(all.ldlt().solve(push));  // the rest gives way
  }

  double ReachOf(const robot::Joint& joint) const {
    const std::vector<bool> moves = BelowOf(joint.child);
    double reach = 0;
    for (size_t i = 0; i < robot_.links.size(); ++i) {
      if (!moves[i]) continue;
      const Vector3 way = ToEigen(robot_.links[i].position.data()) - ToEigen(joint.anchor.data());
      reach = std::max(reach, way.norm());
    }
    return reach;
  }

 private:
  // The motion of what hangs on it, described at the base's center, for an angle's rate of 1.
  static Vector6 WayOf(const robot::Joint& joint) {
    const Vector3 axis = ToEigen(joint.axis.data());
    Vector6 way = Vector6::Zero();
    if (joint.kind == robot::JointKind::kSlider) {
      way.head<3>() = joint.radius * axis;
    } else {
      way.head<3>() = ToEigen(joint.anchor.data()).cross(axis);
      way.tail<3>() = axis;
    }
    return way;
  }

  Matrix6 AtBase(size_t link) const {
    Matrix6 inertia = Matrix6::Zero();
    inertia.topLeftCorner<3, 3>().diagonal().setConstant(robot_.links[link].mass);
    inertia.bottomRightCorner<3, 3>() = inertias_[link];
    return InertiaAt(-ToEigen(robot_.links[link].position.data()), inertia);
  }

  std::vector<bool> BelowOf(int link) const {
    std::vector<bool> below(robot_.links.size(), false);
    below[static_cast<size_t>(link)] = true;
    for (const robot::Branch& branch : robot_.Branches()) {
      if (below[static_cast<size_t>(branch.parent)])
        below[static_cast<size_t>(branch.child)] = true;
    }
    return below;
  }

  const robot::RobotDescription& robot_;
  std::vector<Matrix3> inertias_;
};

JointProperties PropertiesOf(double inertia, double reach, const robot::Gains& gains) {
  JointProperties joint = {.inertia = inertia, .reach = reach};
  if (!gains.HasMotor()) return joint;
  joint.frequency = std::sqrt(gains.stiffness / inertia) / (2 * std::numbers::pi);
  joint.damping_ratio = gains.damping / (2 * std::sqrt(gains.stiffness * inertia));
  return joint;
}

// With the weight of the robot.
void CompareMotors(const robot::RobotDescription& robot, BodyProperties& body) {
  double longest = 0;
  for (const JointProperties& joint : body.joints) longest = std::max(longest, joint.reach);
  const double weight = body.mass * robot::kGravity;
  for (size_t i = 0; i < robot.joints.size(); ++i) {
    const robot::Gains& gains = robot.GainsOf(robot.joints[i]);
    const bool slides = robot.joints[i].kind == robot::JointKind::kSlider;
    if (!gains.HasMotor() || slides || longest == 0) continue;
    body.joints[i].strength = gains.max_torque / (weight * longest);
    body.joints[i].quickness = gains.max_torque / body.joints[i].inertia;
  }
}

}  // namespace

BodyProperties PropertiesOf(const robot::RobotDescription& robot) {
  const Masses masses(robot);
  BodyProperties body;
  for (size_t i = 0; i < robot.links.size(); ++i) {
    const robot::Link& link = robot.links[i];
    body.mass += link.mass;
    body.links.push_back(
        {VolumeOf(link.shape), masses.PrincipalOf(i), BoundingRadiusOfLink(link.shape)});
  }
  for (const robot::Joint& joint : robot.joints) {
    const double inertia = masses.InertiaAbout(joint) + joint.passive.armature;
    body.joints.push_back(PropertiesOf(inertia, masses.ReachOf(joint), robot.GainsOf(joint)));
  }
  CompareMotors(robot, body);
  return body;
}

}  // namespace runtime
