// A joint of one coordinate in an ODE world. What is special in each kind of joint is in its class.
//
// The angle is the robot's (plugins/robot/robot_description.h); what ODE measures along a joint,
// its coordinate, is radius * angle: the angle itself [rad] of what turns, meters of what slides.
#pragma once

#include <memory>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/joint_motor.h"
#include "runtime/training/simulation/ode_library.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// How a link moves: its center, and its turning.
struct LinkVelocity {
  Vector3 linear;
  Vector3 angular;
};

class BodyJoint {
 public:
  virtual ~BodyJoint() = default;

  // ODE's own.
  dJointID id() const { return joint_.get(); }

  // [rad]; of what turns within half a turn to both sides of 0.
  virtual double RawAngle() const = 0;
  virtual double Rate() const = 0;                     // [rad / s]
  virtual void AddTorque(double torque) = 0;           // for the next step [N m]
  virtual void SetStops(double low, double high) = 0;  // as RawAngle() measures
  // Whether the angle comes around.
  virtual bool Turns() const = 0;

  // The motion of the child's center `child`, given that of the parent's center `parent`.
  virtual LinkVelocity Carry(const LinkVelocity& motion, const Vector3& parent,
                             const Vector3& child, double rate) const = 0;

  // A joint of ODE's beside this one that pulls along its coordinate, without effect so far: a
  // built-in motor pushes with all its force at a stop.
  virtual OdeJoint MakePull(dWorldID world) const = 0;
  // What it does in the next step.
  virtual void SetPull(dJointID pull, const Motor& motor) const = 0;

 protected:
  explicit BodyJoint(OdeJoint joint) : joint_(std::move(joint)) {}

 private:
  OdeJoint joint_;
};

// A joint between two bodies in the zero pose. The bodies outlive it.
std::unique_ptr<BodyJoint> MakeBodyJoint(const robot::Joint& joint, dBodyID parent, dBodyID child,
                                         dWorldID world);

// The same for what has no coordinate; with what damps it, if anything does.
struct BodyMount {
  OdeJoint joint;
  OdeJoint damper;
};
BodyMount MakeBodyMount(const robot::Mount& mount, dBodyID parent, dBodyID child, dWorldID world);

}  // namespace runtime
