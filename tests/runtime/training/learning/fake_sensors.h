#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "plugins/robot/sensors.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "tests/runtime/training/learning/test_robot.h"

namespace runtime {

// What the sensors of the humanoid show that a state is made from.
struct FakeSensors {
  std::array<double, 3> base_position{};
  std::array<double, 4> base_orientation{1, 0, 0, 0};
  std::array<double, 3> base_velocity{};
  std::array<double, 3> base_angular_velocity{};
  std::array<double, 17> joint_angle{};
  std::array<double, 17> joint_velocity{};
};

// Out ports for them, as an environment has.
class FakeSensorModule : public Module {
 public:
  // `sensors` stay where they are.
  explicit FakeSensorModule(FakeSensors* sensors) : Module("environment") {
    Add(robot::SensorId::kBasePosition, sensors->base_position.data());
    Add(robot::SensorId::kBaseOrientation, sensors->base_orientation.data());
    Add(robot::SensorId::kBaseVelocity, sensors->base_velocity.data());
    Add(robot::SensorId::kBaseAngularVelocity, sensors->base_angular_velocity.data());
    Add(robot::SensorId::kJointAngle, sensors->joint_angle.data());
    Add(robot::SensorId::kJointVelocity, sensors->joint_velocity.data());
  }

  // Connects all of them to the in ports of the same names.
  void ConnectTo(Module& state) {
    for (const auto& sensor : sensors_) {
      Port::Connect(sensor->port, state.FindPort(sensor->port.name()));
    }
  }

 private:
  struct Sensor {
    Sensor(Module* owner, const robot::SensorDescription& description, const double* elements)
        : data{elements},
          port(owner, std::string(description.name), &data,
               SensorTypeText(description.type, description.unit)) {}
    SensorData data;
    SensorOut port;
  };

  void Add(robot::SensorId id, const double* elements) {
    sensors_.push_back(
        std::make_unique<Sensor>(this, robot::Sensors()[static_cast<size_t>(id)], elements));
  }

  std::vector<std::unique_ptr<Sensor>> sensors_;
};

}  // namespace runtime
