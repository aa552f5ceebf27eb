#include "runtime/training/simulation/robot_body.h"

#include <cmath>
#include <numbers>

#include "runtime/training/simulation/ground_height.h"
#include "runtime/training/simulation/link_frames.h"
#include "runtime/training/simulation/solid_shape.h"

namespace runtime {
namespace {

dMass MassOf(const robot::Link& link) {
  if (link.inertia) {
    const robot::Inertia& m = *link.inertia;
    dMass mass;
    dMassSetParameters(&mass, link.mass, 0, 0, 0, m.xx, m.yy, m.zz, m.xy, m.xz, m.yz);
    return mass;
  }
  dMass mass = MassOfShape(link.shape, link.mass);
  if (!link.shape.IsMoved()) return mass;
  dMatrix3 rotation;
  ToRotation(link.shape.orientation, rotation);
  dMassRotate(&mass, rotation);
  return mass;
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
  link_count_ = body_count();
  if (robot.has_fixed_base) dBodySetKinematic(body(0));
  for (const robot::Joint& joint : robot.joints) {
    joints_.push_back(MakeBodyJoint(joint, body(joint.parent), body(joint.child), world));
  }
  for (const robot::Mount& mount : robot.mounts) {
    mounts_.push_back(MakeBodyMount(mount, body(mount.parent), body(mount.child), world));
  }
  for (const robot::Site& site : robot.sites) sites_.emplace_back(robot, site, body(site.link));
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
  const bool is_convex = link.shape.kind == robot::ShapeKind::kConvex;
  convex_.push_back(is_convex ? std::make_unique<ConvexGeom>(link.shape.points) : nullptr);
  OdeGeom geom = is_convex ? convex_.back()->Make() : GeomOf(link.shape);
  dGeomSetBody(geom.get(), body.get());
  PlaceShape(link.shape, geom.get());
  bodies_.push_back(std::move(body));
  geoms_.push_back(std::move(geom));
}

std::span<const Vector3> RobotBody::corners(int link) const {
  if (convex_[link] == nullptr) return {};
  return convex_[link]->corners();
}

void RobotBody::AddThing(OdeBody body, OdeGeom geom) {
  bodies_.push_back(std::move(body));
  geoms_.push_back(std::move(geom));
}

void RobotBody::Lift(double height) {
  for (int i = 0; i < link_count(); ++i) {
    const dReal* p = dBodyGetPosition(body(i));
    dBodySetPosition(body(i), p[0], p[1], p[2] + height);
  }
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
