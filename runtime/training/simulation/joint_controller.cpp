#include "runtime/training/simulation/joint_controller.h"

#include <algorithm>
#include <cmath>

namespace runtime {

JointController::JointController(const robot::RobotDescription& robot, const RobotBody& body,
                                 double time_step)
    : controller_(robot.controller),
      body_(body),
      targets_(robot.joints.size(), 0.0),
      angles_(robot.joints.size(), 0.0),
      rates_(robot.joints.size(), 0.0),
      torques_(robot.joints.size(), 0.0),
      motors_(robot.joints.size(),
              {.damping = controller_.damping + time_step * controller_.stiffness,
               .max_torque = controller_.max_torque}) {}

void JointController::Update(std::span<const double> targets) {
  for (int j = 0; j < body_.joint_count(); ++j) {
    targets_[j] = targets[j];
    angles_[j] = body_.JointAngle(j);
    rates_[j] = dJointGetHingeAngleRate(body_.hinge(j));
    const double pull = controller_.stiffness * (targets[j] - angles_[j]);
    torques_[j] = std::clamp(pull - controller_.damping * rates_[j], -controller_.max_torque,
                             controller_.max_torque);
    if (!std::isfinite(torques_[j])) throw OdeFailure("the torque of a joint is not a number");
    motors_[j].speed = pull / motors_[j].damping;
  }
}

}  // namespace runtime
