#include "runtime/simulation/joint_controller.h"

#include <algorithm>
#include <cmath>

namespace runtime {

JointController::JointController(const robot::RobotDescription& robot, const RobotBody& body,
                                 dWorldID world, JointDrive drive, double time_step)
    : controller_(robot.controller),
      body_(body),
      drive_(drive),
      motor_damping_(controller_.damping + time_step * controller_.stiffness),
      torques_(robot.joints.size(), 0.0) {
  if (drive_ != JointDrive::kMotor) return;
  for (const robot::Joint& joint : robot.joints) AddMotor(joint, world);
}

// A joint of its own beside the hinge: a hinge's built-in motor pushes with all its force at a
// stop.
void JointController::AddMotor(const robot::Joint& joint, dWorldID world) {
  OdeJoint motor(dJointCreateAMotor(world, nullptr));
  const dBodyID parent = body_.body(joint.parent);
  dJointAttach(motor.get(), parent, body_.body(joint.child));
  dJointSetAMotorNumAxes(motor.get(), 1);
  dVector3 axis;
  dBodyVectorToWorld(parent, joint.axis[0], joint.axis[1], joint.axis[2], axis);
  constexpr int kMovesWithParent = 1;
  dJointSetAMotorAxis(motor.get(), 0, kMovesWithParent, axis[0], axis[1], axis[2]);
  dJointSetAMotorParam(motor.get(), dParamFMax, controller_.max_torque);
  dJointSetAMotorParam(motor.get(), dParamCFM, 1 / motor_damping_);
  motors_.push_back(std::move(motor));
}

// As a motor: the torque at the end of a step of length h, where the angle has become q + h v, is
//   stiffness (target - q - h v) - damping v = stiffness (target - q) - motor_damping v,
// which is what a motor with the velocity stiffness (target - q) / motor_damping and the constraint
// force mixing 1 / motor_damping produces, up to its greatest torque.
void JointController::Apply(std::span<const double> targets) {
  for (int j = 0; j < body_.joint_count(); ++j) {
    const dJointID hinge = body_.hinge(j);
    const double pull = controller_.stiffness * (targets[j] - dJointGetHingeAngle(hinge));
    torques_[j] = std::clamp(pull - controller_.damping * dJointGetHingeAngleRate(hinge),
                             -controller_.max_torque, controller_.max_torque);
    if (!std::isfinite(torques_[j])) throw OdeFailure("the torque of a joint is no number");
    if (drive_ == JointDrive::kTorque) {
      dJointAddHingeTorque(hinge, torques_[j]);
    } else {
      dJointSetAMotorParam(motors_[j].get(), dParamVel, pull / motor_damping_);
    }
  }
}

}  // namespace runtime
