#include "runtime/training/simulation/joint_controller.h"

#include <algorithm>
#include <cmath>

namespace runtime {

JointController::JointController(const robot::RobotDescription& robot, const RobotBody& body,
                                 double time_step)
    : controller_(robot.controller),
      body_(body),
      implicit_damping_(controller_.damping + time_step * controller_.stiffness),
      targets_(robot.joints.size(), 0.0),
      angles_(robot.joints.size(), 0.0),
      rates_(robot.joints.size(), 0.0),
      torques_(robot.joints.size(), 0.0),
      motors_(robot.joints.size()) {}

void JointController::Update(std::span<const double> targets) {
  for (int j = 0; j < body_.joint_count(); ++j) {
    targets_[j] = targets[j];
    angles_[j] = body_.JointAngle(j);
    rates_[j] = dJointGetHingeAngleRate(body_.hinge(j));
    const double pull = controller_.stiffness * (targets[j] - angles_[j]);
    const double torque = pull - controller_.damping * rates_[j];
    const double most = MostTorque(torque, rates_[j]);
    torques_[j] = std::clamp(torque, -most, most);
    if (!std::isfinite(torques_[j])) throw OdeFailure("the torque of a joint is not a number");
    motors_[j] = MotorFor(pull, rates_[j]);
  }
}

double JointController::MostTorque(double drive, double rate) const {
  const double speed = drive < 0 ? -rate : rate;  // in the direction of the drive
  return controller_.max_torque * std::clamp(1 - speed / controller_.max_speed, 0.0, 1.0);
}

// A controller that pulls toward more than the motor's largest speed meets the motor's own line,
// which is that of a motor, too: it pulls toward that speed with all it has at rest. Stepped
// implicitly like the other, no step carries the joint beyond.
Motor JointController::MotorFor(double pull, double rate) const {
  const double speed = pull / implicit_damping_;
  const double torque = pull - implicit_damping_ * rate;
  if (std::abs(speed) <= controller_.max_speed)
    return {speed, implicit_damping_, MostTorque(torque, rate)};
  return {.speed = std::copysign(controller_.max_speed, speed),
          .damping = controller_.max_torque / controller_.max_speed,
          .max_torque = std::min(std::abs(torque), controller_.max_torque)};
}

}  // namespace runtime
