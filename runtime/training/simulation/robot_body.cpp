#include "runtime/training/simulation/robot_body.h"

#include <numbers>

#include "runtime/training/simulation/ground_height.h"
#include "runtime/training/simulation/link_frames.h"

namespace runtime {
namespace {

dMass MassOf(const robot::Link& link) {
  const robot::LinkShape& shape = link.shape;
  dMass mass;
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      dMassSetBoxTotal(&mass, link.mass, shape.size[0], shape.size[1], shape.size[2]);
      break;
    case robot::ShapeKind::kCapsule:
      dMassSetCapsuleTotal(&mass, link.mass, shape.axis + 1, shape.radius,
                           shape.length - 2 * shape.radius);
      break;
    case robot::ShapeKind::kSphere:
      dMassSetSphereTotal(&mass, link.mass, shape.radius);
      break;
  }
  return mass;
}

OdeGeom GeomOf(const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return OdeGeom(dCreateBox(nullptr, shape.size[0], shape.size[1], shape.size[2]));
    case robot::ShapeKind::kCapsule:
      return OdeGeom(dCreateCapsule(nullptr, shape.radius, shape.length - 2 * shape.radius));
    case robot::ShapeKind::kSphere:
      break;
  }
  return OdeGeom(dCreateSphere(nullptr, shape.radius));
}

// ODE's capsules lie along z: turns one within its link so that it lies along its axis.
void AlignCapsule(const robot::LinkShape& shape, dGeomID geom) {
  if (shape.kind != robot::ShapeKind::kCapsule || shape.axis == 2) return;
  dMatrix3 rotation;
  if (shape.axis == 0) dRFromAxisAndAngle(rotation, 0, 1, 0, std::numbers::pi / 2);
  if (shape.axis == 1) dRFromAxisAndAngle(rotation, 1, 0, 0, std::numbers::pi / 2);
  dGeomSetOffsetRotation(geom, rotation);
}

template <class Vector>
Eigen::Vector3d ToEigen(const Vector& v) {
  return {v[0], v[1], v[2]};
}

// Written so that a NaN is outside of every limit.
bool Within(const dReal* vector, double limit) {
  const double square = vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
  return square < limit * limit;
}

}  // namespace

RobotBody::RobotBody(const robot::RobotDescription& robot, const robot::StartState& start,
                     dWorldID world) {
  for (const robot::Link& link : robot.links) AddLink(link, world);
  for (const robot::Joint& joint : robot.joints) AddHinge(joint, world);
  MoveTo(robot, OnGround(robot, start));
  if (!start.IsAtRest()) SetVelocities(robot, start);
}

void RobotBody::AddLink(const robot::Link& link, dWorldID world) {
  OdeBody body(dBodyCreate(world));
  const dMass mass = MassOf(link);
  dBodySetMass(body.get(), &mass);
  dBodySetPosition(body.get(), link.position[0], link.position[1], link.position[2]);
  OdeGeom geom = GeomOf(link.shape);
  dGeomSetBody(geom.get(), body.get());
  AlignCapsule(link.shape, geom.get());
  bodies_.push_back(std::move(body));
  geoms_.push_back(std::move(geom));
}

void RobotBody::AddHinge(const robot::Joint& joint, dWorldID world) {
  OdeJoint hinge(dJointCreateHinge(world, nullptr));
  // The order of the two gives the angle its sign.
  dJointAttach(hinge.get(), body(joint.parent), body(joint.child));
  dJointSetHingeAnchor(hinge.get(), joint.anchor[0], joint.anchor[1], joint.anchor[2]);
  dJointSetHingeAxis(hinge.get(), joint.axis[0], joint.axis[1], joint.axis[2]);
  dJointSetHingeParam(hinge.get(), dParamLoStop, joint.low);
  dJointSetHingeParam(hinge.get(), dParamHiStop, joint.high);
  hinges_.push_back(std::move(hinge));
  middles_.push_back((joint.low + joint.high) / 2);
}

double RobotBody::JointAngle(int joint) const {
  using std::numbers::pi;
  const double angle = dJointGetHingeAngle(hinge(joint));
  const double middle = middles_[joint];
  if (angle > middle + pi) return angle - 2 * pi;
  if (angle < middle - pi) return angle + 2 * pi;
  return angle;
}

void RobotBody::MoveTo(const robot::RobotDescription& robot, const robot::Pose& pose) {
  const std::vector<LinkFrame> frames = LinkFrames(robot, pose);
  for (int i = 0; i < link_count(); ++i) {
    const Eigen::Vector3d& p = frames[i].position;
    const Eigen::Quaterniond& q = frames[i].orientation;
    const dQuaternion orientation = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body(i), p.x(), p.y(), p.z());
    dBodySetQuaternion(body(i), orientation);
  }
}

// From the base outwards: each joint turns what hangs on it by minus its rate about its axis.
void RobotBody::SetVelocities(const robot::RobotDescription& robot,
                              const robot::StartState& start) {
  struct Motion {
    Eigen::Vector3d linear;
    Eigen::Vector3d angular;
  };
  std::vector<Motion> motions(robot.links.size());
  motions[0] = {ToEigen(start.velocity), ToEigen(start.angular_velocity)};
  for (size_t j = 0; j < robot.joints.size(); ++j) {
    const robot::Joint& joint = robot.joints[j];
    dVector3 anchor;
    dVector3 axis;
    dJointGetHingeAnchor(hinge(static_cast<int>(j)), anchor);
    dJointGetHingeAxis(hinge(static_cast<int>(j)), axis);
    const Motion& parent = motions[joint.parent];
    Motion& child = motions[joint.child];
    const Eigen::Vector3d at_anchor =
        parent.linear + parent.angular.cross(ToEigen(anchor) - PositionOf(joint.parent));
    child.angular = parent.angular - start.joint_velocities[j] * ToEigen(axis);
    child.linear = at_anchor + child.angular.cross(PositionOf(joint.child) - ToEigen(anchor));
  }
  for (int i = 0; i < link_count(); ++i) {
    const auto& [linear, angular] = motions[i];
    dBodySetLinearVel(body(i), linear.x(), linear.y(), linear.z());
    dBodySetAngularVel(body(i), angular.x(), angular.y(), angular.z());
  }
}

Eigen::Vector3d RobotBody::PositionOf(int link) const {
  return ToEigen(dBodyGetPosition(body(link)));
}

bool RobotBody::IsPlausible() const {
  for (const OdeBody& body : bodies_) {
    if (!Within(dBodyGetLinearVel(body.get()), robot::kFastest) ||
        !Within(dBodyGetAngularVel(body.get()), robot::kFastestRotation)) {
      return false;
    }
  }
  return true;
}

}  // namespace runtime
