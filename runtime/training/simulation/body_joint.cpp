#include "runtime/training/simulation/body_joint.h"

#include <cassert>
#include <utility>

namespace runtime {
namespace {

constexpr int kMovesWithParent = 1;

class HingeJoint : public BodyJoint {
 public:
  HingeJoint(const robot::Joint& joint, dBodyID parent, dBodyID child, dWorldID world)
      : BodyJoint(OdeJoint(dJointCreateHinge(world, nullptr))) {
    // The order of the two gives the angle its sign.
    dJointAttach(id(), parent, child);
    dJointSetHingeAnchor(id(), joint.anchor[0], joint.anchor[1], joint.anchor[2]);
    dJointSetHingeAxis(id(), joint.axis[0], joint.axis[1], joint.axis[2]);
    if (joint.HasStops()) HingeJoint::SetStops(joint.low, joint.high);
  }

  double RawAngle() const override { return dJointGetHingeAngle(id()); }
  double Rate() const override { return dJointGetHingeAngleRate(id()); }
  void AddTorque(double torque) override { dJointAddHingeTorque(id(), torque); }
  void SetStops(double low, double high) override {
    dJointSetHingeParam(id(), dParamLoStop, low);
    dJointSetHingeParam(id(), dParamHiStop, high);
  }
  bool Turns() const override { return true; }

  LinkVelocity Carry(const LinkVelocity& motion, const Vector3& parent, const Vector3& child,
                     double rate) const override {
    dVector3 anchor_elements;
    dVector3 axis;
    dJointGetHingeAnchor(id(), anchor_elements);
    dJointGetHingeAxis(id(), axis);
    const Vector3 anchor = ToEigen(anchor_elements);
    const Vector3 at_anchor = motion.linear + motion.angular.cross(anchor - parent);
    const Vector3 angular = motion.angular - rate * ToEigen(axis);
    return {at_anchor + angular.cross(child - anchor), angular};
  }

  OdeJoint MakePull(dWorldID world) const override {
    OdeJoint pull(dJointCreateAMotor(world, nullptr));
    dJointAttach(pull.get(), dJointGetBody(id(), 0), dJointGetBody(id(), 1));
    dJointSetAMotorNumAxes(pull.get(), 1);
    dVector3 axis;
    dJointGetHingeAxis(id(), axis);
    dJointSetAMotorAxis(pull.get(), 0, kMovesWithParent, axis[0], axis[1], axis[2]);
    return pull;
  }
  void SetPull(dJointID pull, const Motor& motor) const override {
    dJointSetAMotorParam(pull, dParamFMax, motor.max_torque);
    dJointSetAMotorParam(pull, dParamCFM, 1 / motor.damping);
    dJointSetAMotorParam(pull, dParamVel, motor.speed);
  }
};

// ODE's slider measures how far the parent is ahead of the child along its axis, so that axis is
// the opposite of the robot's.
class SliderJoint : public BodyJoint {
 public:
  SliderJoint(const robot::Joint& joint, dBodyID parent, dBodyID child, dWorldID world)
      : BodyJoint(OdeJoint(dJointCreateSlider(world, nullptr))), radius_(joint.radius) {
    dJointAttach(id(), parent, child);
    dJointSetSliderAxis(id(), -joint.axis[0], -joint.axis[1], -joint.axis[2]);
    if (joint.HasStops()) SliderJoint::SetStops(joint.low, joint.high);
  }

  double RawAngle() const override { return dJointGetSliderPosition(id()) / radius_; }
  // ODE's own rate leaves out that the axis turns with the parent.
  double Rate() const override {
    const dBodyID parent = dJointGetBody(id(), 0);
    const dBodyID child = dJointGetBody(id(), 1);
    const Vector3 between = ToEigen(dBodyGetPosition(child)) - ToEigen(dBodyGetPosition(parent));
    const Vector3 lag = ToEigen(dBodyGetLinearVel(parent)) +
                        ToEigen(dBodyGetAngularVel(parent)).cross(between) -
                        ToEigen(dBodyGetLinearVel(child));
    dVector3 axis;
    dJointGetSliderAxis(id(), axis);
    return ToEigen(axis).dot(lag) / radius_;
  }
  void AddTorque(double torque) override { dJointAddSliderForce(id(), torque / radius_); }
  void SetStops(double low, double high) override {
    dJointSetSliderParam(id(), dParamLoStop, low * radius_);
    dJointSetSliderParam(id(), dParamHiStop, high * radius_);
  }
  bool Turns() const override { return false; }

  LinkVelocity Carry(const LinkVelocity& motion, const Vector3& parent, const Vector3& child,
                     double rate) const override {
    dVector3 axis;
    dJointGetSliderAxis(id(), axis);
    return {motion.linear + motion.angular.cross(child - parent) - rate * radius_ * ToEigen(axis),
            motion.angular};
  }

  OdeJoint MakePull(dWorldID world) const override {
    OdeJoint pull(dJointCreateLMotor(world, nullptr));
    dJointAttach(pull.get(), dJointGetBody(id(), 0), dJointGetBody(id(), 1));
    dJointSetLMotorNumAxes(pull.get(), 1);
    dVector3 axis;
    dJointGetSliderAxis(id(), axis);
    dJointSetLMotorAxis(pull.get(), 0, kMovesWithParent, axis[0], axis[1], axis[2]);
    return pull;
  }
  void SetPull(dJointID pull, const Motor& motor) const override {
    dJointSetLMotorParam(pull, dParamFMax, motor.max_torque / radius_);
    dJointSetLMotorParam(pull, dParamCFM, radius_ * radius_ / motor.damping);
    dJointSetLMotorParam(pull, dParamVel, motor.speed * radius_);
  }

 private:
  double radius_;
};

OdeJoint MakeFixed(dBodyID parent, dBodyID child, dWorldID world) {
  OdeJoint joint(dJointCreateFixed(world, nullptr));
  dJointAttach(joint.get(), parent, child);
  dJointSetFixed(joint.get());
  return joint;
}

OdeJoint MakeBall(const robot::Vector3& anchor, dBodyID parent, dBodyID child, dWorldID world) {
  OdeJoint joint(dJointCreateBall(world, nullptr));
  dJointAttach(joint.get(), parent, child);
  dJointSetBallAnchor(joint.get(), anchor[0], anchor[1], anchor[2]);
  return joint;
}

// Resists turns about all axes alike.
OdeJoint MakeDamper(double damping, dBodyID parent, dBodyID child, dWorldID world) {
  constexpr int kAtRest = 0;  // in the world
  OdeJoint joint(dJointCreateAMotor(world, nullptr));
  dJointAttach(joint.get(), parent, child);
  dJointSetAMotorNumAxes(joint.get(), 3);
  dJointSetAMotorAxis(joint.get(), 0, kAtRest, 1, 0, 0);
  dJointSetAMotorAxis(joint.get(), 1, kAtRest, 0, 1, 0);
  dJointSetAMotorAxis(joint.get(), 2, kAtRest, 0, 0, 1);
  for (const int parameters : {dParamLoStop1, dParamLoStop2, dParamLoStop3}) {
    dJointSetAMotorParam(joint.get(), parameters + dParamFMax, dInfinity);
    dJointSetAMotorParam(joint.get(), parameters + dParamCFM, 1 / damping);
  }
  return joint;
}

}  // namespace

std::unique_ptr<BodyJoint> MakeBodyJoint(const robot::Joint& joint, dBodyID parent, dBodyID child,
                                         dWorldID world) {
  switch (joint.kind) {
    case robot::JointKind::kHinge:
    case robot::JointKind::kContinuous:
      return std::make_unique<HingeJoint>(joint, parent, child, world);
    case robot::JointKind::kSlider:
      return std::make_unique<SliderJoint>(joint, parent, child, world);
  }
  assert(!"a kind of joint");
  return nullptr;
}

BodyMount MakeBodyMount(const robot::Mount& mount, dBodyID parent, dBodyID child, dWorldID world) {
  switch (mount.kind) {
    case robot::MountKind::kFixed:
      return {MakeFixed(parent, child, world), nullptr};
    case robot::MountKind::kBall:
      return {MakeBall(mount.anchor, parent, child, world),
              mount.damper > 0 ? MakeDamper(mount.damper, parent, child, world) : nullptr};
  }
  assert(!"a kind of mount");
  return {};
}

}  // namespace runtime
