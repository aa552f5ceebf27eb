// What drives the joints: the low-level controller, by which each is drawn to its target by a
// spring and a damper within the limits of its torque and its speed, and what acts on a joint by
// itself.
#pragma once

#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/joint_motor.h"
#include "runtime/training/simulation/profile.h"
#include "runtime/training/simulation/robot_body.h"

namespace runtime {

class JointController {
 public:
  // `body` outlives the object. `cfm`: what makes dry friction as stiff as the solver has it.
  JointController(const robot::RobotDescription& robot, const RobotBody& body,
                  const Profile& profile, double time_step, double cfm);

  // Reads the joints and finds what drives each toward its target [rad] during the next physics
  // step. Throws OdeFailure if that takes a torque that is not a number: no solver must get to see
  // one.
  void Update(std::span<const double> targets);

  // All from the last update.
  std::span<const double> targets() const { return targets_; }  // [rad]; 0 before the first
  std::span<const double> angles() const { return angles_; }    // [rad]
  std::span<const double> rates() const { return rates_; }      // of the angles [rad/s]
  // [N m]: clip(stiffness * (target - angle) - damping * rate, max_torque), and no more than the
  // motor has at that speed; where it is turned faster than it can turn by itself, it brakes.
  std::span<const double> torques() const { return torques_; }
  // What pulls the joint during the next step besides that torque, as many as ever: where the
  // profile drives joints by motors, that motor in place of the torque; where the joint has any of
  // them, its spring, damper and armature, which are one; its friction.
  std::span<const Motor> pulls(int joint) const {
    return {pulls_.data() + first_pulls_[joint], pulls_.data() + first_pulls_[joint + 1]};
  }
  // Whether the joints are driven by motors, and not by the torques.
  bool has_motors() const { return has_motors_; }

 private:
  struct Drive {
    robot::Gains gains;
    double implicit_damping;  // damping + h stiffness [N m s / rad]

    // The most that a motor has to give in the direction of `speed` [rad/s]: less than nothing
    // where it is turned faster than it can turn by itself [N m].
    double MostTorque(double speed) const;
    Motor MotorFor(double pull, double rate) const;
  };
  struct Passive {
    robot::PassiveForces forces;
    double inertia;  // armature / h
    double damping;  // all that acts against the speed at the end of a step [N m s / rad]

    Motor MotorAt(double angle, double rate) const;
  };

  bool HasMotor(const robot::Gains& gains) const;
  void UpdatePulls(int joint, double pull);

  const RobotBody& body_;
  bool has_motors_;
  double friction_damping_;
  std::vector<Drive> drives_;
  std::vector<Passive> passives_;
  std::vector<double> targets_;
  std::vector<double> angles_;
  std::vector<double> rates_;
  std::vector<double> torques_;
  std::vector<Motor> pulls_;         // of all joints
  std::vector<size_t> first_pulls_;  // of each joint, and one more
};

}  // namespace runtime
