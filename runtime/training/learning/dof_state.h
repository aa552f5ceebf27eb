#pragma once

#include <string>

#include "plugins/robot/sensors.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/training/learning/state.h"

namespace runtime {

// Makes the learner's state from the sensors of the robot, for one of its DoF configurations.
class DofState : public Module, public State {
 public:
  DofState(std::string name, const Context& context);

  void Start() override;

  const robot::DofConfiguration& dof() const override;
  const Eigen::VectorXd& Read() const override;

 private:
  const robot::RobotDescription& robot_;
  std::string dof_name_ = "5";

  const robot::DofConfiguration* dof_ = nullptr;  // set by Start
  mutable Eigen::VectorXd values_;                // brought up to date by Read

  SensorIn base_position_;
  SensorIn base_orientation_;
  SensorIn joint_angle_;
  SensorIn base_velocity_;
  SensorIn base_angular_velocity_;
  SensorIn joint_velocity_;
  Out<State> state_{this, "state", this};
};

}  // namespace runtime
