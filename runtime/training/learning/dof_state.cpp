#include "runtime/training/learning/dof_state.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "runtime/base/suggestion.h"
#include "runtime/core/module/connections.h"

namespace runtime {
namespace {

SensorIn MakeSensorIn(Module* owner, robot::SensorId id) {
  const robot::SensorDescription& sensor = robot::Sensors()[static_cast<size_t>(id)];
  return SensorIn(owner, std::string(sensor.name), SensorTypeText(sensor.type, sensor.unit));
}

}  // namespace

DofState::DofState(std::string name, const Context& context)
    : Module(std::move(name)),
      robot_(*context.robot),
      base_position_(MakeSensorIn(this, robot::SensorId::kBasePosition)),
      base_orientation_(MakeSensorIn(this, robot::SensorId::kBaseOrientation)),
      joint_angle_(MakeSensorIn(this, robot::SensorId::kJointAngle)),
      base_velocity_(MakeSensorIn(this, robot::SensorId::kBaseVelocity)),
      base_angular_velocity_(MakeSensorIn(this, robot::SensorId::kBaseAngularVelocity)),
      joint_velocity_(MakeSensorIn(this, robot::SensorId::kJointVelocity)) {
  AddParameter({.name = "dof",
                .doc = "DoF configuration of the robot",
                .target = &dof_name_,
                .is_live = false});
}

void DofState::Start() {
  RequireConnections(*this);
  dof_ = &dof();
  values_.setZero(Size(dof_->dof()));
}

const robot::DofConfiguration& DofState::dof() const {
  if (const robot::DofConfiguration* found = robot_.FindDof(dof_name_)) return *found;
  std::vector<std::string> names;
  for (const robot::DofConfiguration& dof : robot_.dof_configurations) names.push_back(dof.name);
  throw UserError(fmt::format("`{}.dof`: the robot `{}` has no DoF configuration `{}`{}",
                              Module::name(), robot_.name, dof_name_,
                              Suggestion(dof_name_, names)));
}

const Eigen::VectorXd& DofState::Read() const {
  using Eigen::Map, Eigen::Vector3d, Eigen::Vector4d;
  const int dof = dof_->dof();
  const double* angles = joint_angle_().reals();
  const double* rates = joint_velocity_().reals();

  values_[kHeight] = base_position_().reals()[2];
  values_.segment<4>(kOrientation) = Map<const Vector4d>(base_orientation_().reals());
  values_.segment<3>(VelocityIndex(dof)) = Map<const Vector3d>(base_velocity_().reals());
  values_.segment<3>(VelocityIndex(dof) + 3) =
      Map<const Vector3d>(base_angular_velocity_().reals());
  for (int i = 0; i < dof; ++i) {
    const int joint = dof_->representatives[i];
    values_[kAngles + i] = angles[joint];
    values_[RateIndex(dof) + i] = rates[joint];
  }
  return values_;
}

}  // namespace runtime
