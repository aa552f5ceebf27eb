#include "runtime/import/joint_parts.h"

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

constexpr double kLongTravel = 100;  // of a slider without stops [m]

double ReferenceOf(const mjModel& model, int index) {
  return model.qpos0[model.jnt_qposadr[index]];
}

}  // namespace

bool ReadStops(const mjModel& model, int index, robot::Joint& joint) {
  const bool slides = model.jnt_type[index] == mjJNT_SLIDE;
  joint.kind = slides ? robot::JointKind::kSlider : robot::JointKind::kHinge;
  if (model.jnt_limited[index] == 0) {
    if (!slides) joint.kind = robot::JointKind::kContinuous;
    joint.low = slides ? -kLongTravel : -robot::kUnlimited;
    joint.high = -joint.low;
    return true;
  }
  joint.low = model.jnt_range[2 * index] - ReferenceOf(model, index);
  joint.high = model.jnt_range[2 * index + 1] - ReferenceOf(model, index);
  return joint.low < joint.high;
}

robot::PassiveForces PassiveForcesOf(const mjModel& model, int index) {
  const int dof = model.jnt_dofadr[index];
  return {.spring = model.jnt_stiffness[index],
          .spring_rest = model.qpos_spring[model.jnt_qposadr[index]] - ReferenceOf(model, index),
          .damper = model.dof_damping[dof],
          .friction = model.dof_frictionloss[dof],
          .armature = model.dof_armature[dof]};
}

robot::OwnGains MotorOf(const ModelFile& file, const mjModel& model, int index,
                        const std::string& name) {
  robot::OwnGains gains;
  bool is_driven = file.is_urdf();
  for (int a = 0; a < model.nu; ++a) {
    const bool is_joint = model.actuator_trntype[a] == mjTRN_JOINT;
    if (!is_joint || model.actuator_trnid[2 * a] != index) continue;
    is_driven = true;
    const double gear = std::abs(model.actuator_gear[6 * a]);
    const double gain = model.actuator_gainprm[mjNGAIN * a];
    const double* bias = model.actuator_biasprm + mjNBIAS * a;
    if (bias[1] < 0) {
      gains.stiffness = -bias[1] * gear * gear;
      if (bias[2] < 0) gains.damping = -bias[2] * gear * gear;
    } else if (model.actuator_ctrllimited[a] != 0) {
      gains.max_torque = std::abs(gain * model.actuator_ctrlrange[2 * a + 1]) * gear;
    }
    if (model.actuator_forcelimited[a] != 0)
      gains.max_torque = model.actuator_forcerange[2 * a + 1] * gear;
  }
  if (const auto limits = file.limits().find(name); limits != file.limits().end()) {
    const double effort = limits->second.effort;
    if (effort > 0) gains.max_torque = std::min(gains.max_torque.value_or(effort), effort);
    if (limits->second.velocity > 0) gains.max_speed = limits->second.velocity;
  }
  if (gains.max_torque && !(*gains.max_torque > 0)) gains.max_torque.reset();
  if (!is_driven) gains = {.stiffness = 0, .damping = 0, .max_torque = 0, .max_speed = {}};
  return gains;
}

}  // namespace runtime
