// The low-level controller of the joints: each is drawn to its target by a spring and a damper,
// within the limits of its torque and its speed.
#pragma once

#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/robot_body.h"

namespace runtime {

// The motor that is the controller stepped implicitly. The torque at the end of a step of length h,
// where the angle has become q + h v, is
//   stiffness (target - q - h v) - damping v = stiffness (target - q) - (damping + h stiffness) v,
// that of a motor which pulls toward a speed with a torque proportional to what is missing.
struct Motor {
  double speed = 0;       // [rad / s]
  double damping = 0;     // torque for each rad / s that is missing [N m s / rad]
  double max_torque = 0;  // [N m]
};

class JointController {
 public:
  // `controller` and `body` outlive the object.
  JointController(const robot::RobotDescription& robot, const RobotBody& body, double time_step);

  // Reads the joints and finds what drives each toward its target [rad] during the next physics
  // step. Throws OdeFailure if that takes a torque that is not a number: no solver must get to see
  // one.
  void Update(std::span<const double> targets);

  // All from the last update.
  std::span<const double> targets() const { return targets_; }  // [rad]; 0 before the first
  std::span<const double> angles() const { return angles_; }    // [rad]
  std::span<const double> rates() const { return rates_; }      // of the angles [rad/s]
  // [N m]: clip(stiffness * (target - angle) - damping * rate, max_torque), and no more than the
  // motor has at that speed.
  std::span<const double> torques() const { return torques_; }
  std::span<const Motor> motors() const { return motors_; }

 private:
  // The most that a motor has to give in the direction of `drive` at a speed of `rate` [N m].
  double MostTorque(double drive, double rate) const;
  Motor MotorFor(double pull, double rate) const;

  const robot::Controller& controller_;
  const RobotBody& body_;
  const double implicit_damping_;  // damping + h stiffness [N m s / rad]
  std::vector<double> targets_;
  std::vector<double> angles_;
  std::vector<double> rates_;
  std::vector<double> torques_;
  std::vector<Motor> motors_;
};

}  // namespace runtime
