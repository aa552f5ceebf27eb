// The low-level controller of the joints: each is drawn to its target by a spring and a damper,
// within the limit of its torque.
#pragma once

#include <span>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/simulation/profile.h"
#include "runtime/simulation/robot_body.h"

namespace runtime {

class JointController {
 public:
  // `controller`, `world` and `body` outlive the object.
  JointController(const robot::RobotDescription& robot, const RobotBody& body, dWorldID world,
                  JointDrive drive, double time_step);

  // Drives every joint towards its target [rad] during the next physics step. Throws OdeFailure if
  // that takes a torque that is no number: ODE must not get to see one.
  void Apply(std::span<const double> targets);

  // What the last Apply() asked for [N m]:
  // clip(stiffness * (target - angle) - damping * rate, max_torque).
  std::span<const double> torques() const { return torques_; }

 private:
  void AddMotor(const robot::Joint& joint, dWorldID world);

  const robot::Controller& controller_;
  const RobotBody& body_;
  JointDrive drive_;
  double motor_damping_;          // N m s / rad, see Apply()
  std::vector<OdeJoint> motors_;  // for JointDrive::kMotor
  std::vector<double> torques_;
};

}  // namespace runtime
