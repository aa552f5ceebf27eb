#include "runtime/training/simulation/robot_body.h"

#include <cmath>
#include <numbers>

#include "runtime/training/simulation/ground_height.h"
#include "runtime/training/simulation/link_frames.h"

namespace runtime {
namespace {

// Along the axes of the shape.
dMass MassOfShape(const robot::Link& link) {
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
    case robot::ShapeKind::kCylinder:
      dMassSetCylinderTotal(&mass, link.mass, shape.axis + 1, shape.radius, shape.length);
      break;
    case robot::ShapeKind::kSphere:
      dMassSetSphereTotal(&mass, link.mass, shape.radius);
      break;
  }
  return mass;
}

void ToRotation(const robot::Quaternion& quaternion, dMatrix3 rotation) {
  const dQuaternion q = {quaternion[0], quaternion[1], quaternion[2], quaternion[3]};
  dQtoR(q, rotation);
}

dMass MassOf(const robot::Link& link) {
  if (link.inertia) {
    const robot::Inertia& m = *link.inertia;
    dMass mass;
    dMassSetParameters(&mass, link.mass, 0, 0, 0, m.xx, m.yy, m.zz, m.xy, m.xz, m.yz);
    return mass;
  }
  dMass mass = MassOfShape(link);
  if (!link.shape.IsMoved()) return mass;
  dMatrix3 rotation;
  ToRotation(link.shape.orientation, rotation);
  dMassRotate(&mass, rotation);
  return mass;
}

OdeGeom GeomOf(const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return OdeGeom(dCreateBox(nullptr, shape.size[0], shape.size[1], shape.size[2]));
    case robot::ShapeKind::kCapsule:
      return OdeGeom(dCreateCapsule(nullptr, shape.radius, shape.length - 2 * shape.radius));
    case robot::ShapeKind::kCylinder:
      return OdeGeom(dCreateCylinder(nullptr, shape.radius, shape.length));
    case robot::ShapeKind::kSphere:
      break;
  }
  return OdeGeom(dCreateSphere(nullptr, shape.radius));
}

// ODE's capsules and cylinders lie along z: the turn that lays one along its axis.
void RotationOfAxis(const robot::LinkShape& shape, dMatrix3 rotation) {
  const bool has_axis =
      shape.kind == robot::ShapeKind::kCapsule || shape.kind == robot::ShapeKind::kCylinder;
  dRSetIdentity(rotation);
  if (has_axis && shape.axis == 0) dRFromAxisAndAngle(rotation, 0, 1, 0, std::numbers::pi / 2);
  if (has_axis && shape.axis == 1) dRFromAxisAndAngle(rotation, 1, 0, 0, std::numbers::pi / 2);
}

// Puts a shape to its place in its link.
void PlaceShape(const robot::LinkShape& shape, dGeomID geom) {
  dMatrix3 along;
  RotationOfAxis(shape, along);
  const bool is_along_z = along[0] == 1 && along[5] == 1;
  if (is_along_z && !shape.IsMoved()) return;
  if (!shape.IsMoved()) return dGeomSetOffsetRotation(geom, along);
  dMatrix3 turn;
  dMatrix3 rotation;
  ToRotation(shape.orientation, turn);
  dMultiply0(rotation, turn, along, 3, 3, 3);
  dGeomSetOffsetPosition(geom, shape.position[0], shape.position[1], shape.position[2]);
  dGeomSetOffsetRotation(geom, rotation);
}

// Where the stops leave no more than what a hinge of ODE's can measure.
bool IsWithinHalfTurns(const robot::Joint& joint) {
  return joint.low >= -std::numbers::pi && joint.high <= std::numbers::pi;
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
  if (robot.has_fixed_base) dBodySetKinematic(body(0));
  for (const robot::Joint& joint : robot.joints) {
    joints_.push_back(MakeBodyJoint(joint, body(joint.parent), body(joint.child), world));
  }
  for (const robot::Mount& mount : robot.mounts) {
    mounts_.push_back(MakeBodyMount(mount, body(mount.parent), body(mount.child), world));
  }
  const robot::Pose pose = OnGround(robot, start);
  SetReferences(robot, pose);
  MoveTo(robot, pose);
  if (!start.IsAtRest()) SetVelocities(robot, start);
}

void RobotBody::AddLink(const robot::Link& link, dWorldID world) {
  OdeBody body(dBodyCreate(world));
  const dMass mass = MassOf(link);
  dBodySetMass(body.get(), &mass);
  dBodySetPosition(body.get(), link.position[0], link.position[1], link.position[2]);
  OdeGeom geom = GeomOf(link.shape);
  dGeomSetBody(geom.get(), body.get());
  PlaceShape(link.shape, geom.get());
  bodies_.push_back(std::move(body));
  geoms_.push_back(std::move(geom));
}

void RobotBody::SetReferences(const robot::RobotDescription& robot, const robot::Pose& pose) {
  for (size_t j = 0; j < robot.joints.size(); ++j) {
    const robot::Joint& joint = robot.joints[j];
    const bool is_counted = joints_[j]->Turns() && !IsWithinHalfTurns(joint);
    references_.push_back(is_counted ? pose.joint_angles[j] : (joint.low + joint.high) / 2);
    if (is_counted) turning_.push_back(static_cast<int>(j));
  }
}

double RobotBody::JointAngle(int joint) const {
  const double angle = joints_[joint]->RawAngle();
  if (!joints_[joint]->Turns()) return angle;
  constexpr double kTurn = 2 * std::numbers::pi;
  return angle + kTurn * std::nearbyint((references_[joint] - angle) / kTurn);
}

void RobotBody::CountTurns() {
  for (const int joint : turning_) references_[joint] = JointAngle(joint);
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

// From the base outwards: each link moves as its parent does, but for the rate of its joint.
void RobotBody::SetVelocities(const robot::RobotDescription& robot,
                              const robot::StartState& start) {
  std::vector<LinkVelocity> motions(robot.links.size());
  motions[0] = {ToEigen(start.velocity.data()), ToEigen(start.angular_velocity.data())};
  if (robot.has_fixed_base) motions[0] = {Vector3::Zero(), Vector3::Zero()};
  for (const robot::Branch& branch : robot.Branches()) {
    const LinkVelocity& parent = motions[branch.parent];
    const Vector3 from = PositionOf(branch.parent);
    const Vector3 to = PositionOf(branch.child);
    motions[branch.child] =
        branch.joint < 0
            ? LinkVelocity{parent.linear + parent.angular.cross(to - from), parent.angular}
            : joint(branch.joint).Carry(parent, from, to, start.joint_velocities[branch.joint]);
  }
  for (int i = 0; i < link_count(); ++i) {
    const auto& [linear, angular] = motions[i];
    dBodySetLinearVel(body(i), linear.x(), linear.y(), linear.z());
    dBodySetAngularVel(body(i), angular.x(), angular.y(), angular.z());
  }
}

Vector3 RobotBody::PositionOf(int link) const { return ToEigen(dBodyGetPosition(body(link))); }

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
