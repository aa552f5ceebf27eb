#include "runtime/training/learning/dof_state.h"

#include <utility>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/dof_configuration.h"
#include "runtime/training/learning/robot_sensor_in.h"

namespace runtime {

DofState::DofState(std::string name, const Context& context)
    : Module(std::move(name)),
      robot_(RobotOf(context, this->name())),
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
  return FindDof(robot_, dof_name_, name() + ".dof");
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
