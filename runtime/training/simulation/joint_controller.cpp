#include "runtime/training/simulation/joint_controller.h"

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

bool Acts(const robot::PassiveForces& forces) {
  return forces.spring > 0 || forces.damper > 0 || forces.armature > 0;
}

}  // namespace

JointController::JointController(const robot::RobotDescription& robot, const RobotBody& body,
                                 const Profile& profile, double time_step, double cfm)
    : body_(body),
      has_motors_(profile.drive == JointDrive::kMotor),
      friction_damping_(1 / cfm),
      targets_(robot.joints.size(), 0.0),
      angles_(robot.joints.size(), 0.0),
      rates_(robot.joints.size(), 0.0),
      torques_(robot.joints.size(), 0.0) {
  first_pulls_.push_back(0);
  for (const robot::Joint& joint : robot.joints) {
    const robot::Gains gains = robot.GainsOf(joint);
    const robot::PassiveForces& forces = joint.passive;
    const double inertia = forces.armature / time_step;
    drives_.push_back({gains, gains.damping + time_step * gains.stiffness});
    passives_.push_back({forces, inertia, inertia + forces.damper + time_step * forces.spring});
    const size_t pulls = (HasMotor(gains) ? 1 : 0) + (Acts(forces) ? 1 : 0) + (forces.friction > 0);
    first_pulls_.push_back(first_pulls_.back() + pulls);
  }
  pulls_.resize(first_pulls_.back());
}

bool JointController::HasMotor(const robot::Gains& gains) const {
  return has_motors_ && gains.HasMotor();
}

void JointController::Update(std::span<const double> targets) {
  for (int j = 0; j < body_.joint_count(); ++j) {
    const Drive& drive = drives_[j];
    targets_[j] = targets[j];
    angles_[j] = body_.JointAngle(j);
    rates_[j] = body_.joint(j).Rate();
    const double pull = drive.gains.stiffness * (targets[j] - angles_[j]);
    const double torque = pull - drive.gains.damping * rates_[j];
    torques_[j] = std::clamp(torque, -drive.MostTorque(-rates_[j]), drive.MostTorque(rates_[j]));
    if (!std::isfinite(torques_[j])) throw OdeFailure("the torque of a joint is not a number");
    UpdatePulls(j, pull);
  }
}

void JointController::UpdatePulls(int joint, double pull) {
  Motor* next = &pulls_[first_pulls_[joint]];
  if (HasMotor(drives_[joint].gains)) *next++ = drives_[joint].MotorFor(pull, rates_[joint]);
  const Passive& passive = passives_[joint];
  if (Acts(passive.forces)) *next++ = passive.MotorAt(angles_[joint], rates_[joint]);
  if (passive.forces.friction > 0) *next = {0, friction_damping_, passive.forces.friction};
}

double JointController::Drive::MostTorque(double speed) const {
  return gains.max_torque * std::clamp(1 - speed / gains.max_speed, -1.0, 1.0);
}

// A controller that pulls toward more than the motor's largest speed meets the motor's own line,
// which is that of a motor, too: it pulls toward that speed with all it has at rest. Stepped
// implicitly like the other, no step carries the joint beyond.
Motor JointController::Drive::MotorFor(double pull, double rate) const {
  const double speed = pull / implicit_damping;
  const double torque = pull - implicit_damping * rate;
  if (std::abs(speed) <= gains.max_speed)
    return {speed, implicit_damping, MostTorque(torque < 0 ? -rate : rate)};
  return {.speed = std::copysign(gains.max_speed, speed),
          .damping = gains.max_torque / gains.max_speed,
          .max_torque = std::min(std::abs(torque), gains.max_torque)};
}

// An armature resists what changes its speed: armature / h * (rate - v).
Motor JointController::Passive::MotorAt(double angle, double rate) const {
  const double torque = inertia * rate + forces.spring * (forces.spring_rest - angle);
  return {torque / damping, damping, robot::kUnlimited};
}

}  // namespace runtime
