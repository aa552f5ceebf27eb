// What a task, or a state, can sense of a robot in a world.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/sensors.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/training/simulation/world.h"

namespace runtime {

class RobotSensors;

// One sensor's elements, brought up to date when they are read: at most once after each Refresh().
class RobotSensor {
 public:
  RobotSensor(RobotSensors* all, const robot::SensorDescription& description, int element_count);

  const robot::SensorDescription& description() const { return *description_; }
  inline const SensorData& Read();

 private:
  friend class RobotSensors;
  void Compute();

  RobotSensors* all_;
  const robot::SensorDescription* description_;
  std::vector<double> reals_;
  std::unique_ptr<bool[]> flags_;
  SensorData data_;
  uint64_t moment_ = 0;  // of the last computation
};

// The memory of all sensors stays where it is as long as this object lives.
class RobotSensors {
 public:
  explicit RobotSensors(const robot::RobotDescription& robot);

  std::deque<RobotSensor>& sensors() { return sensors_; }

  // From now on the sensors show `world`, `time` seconds after the start of the episode. To be
  // called whenever the world has changed; `world` must stay until the next call.
  void Refresh(const World& world, double time);
  // From now on the sensors show what they showed when they were last read.
  void Freeze();

 private:
  friend class RobotSensor;

  const World* world_ = nullptr;
  double time_ = 0;
  uint64_t moment_ = 0;
  std::deque<RobotSensor> sensors_;
};

// Here, since each task reads each of its sensors in each event: mostly there is nothing to do.
const SensorData& RobotSensor::Read() {
  if (moment_ != all_->moment_) {
    moment_ = all_->moment_;
    Compute();
  }
  return data_;
}

}  // namespace runtime
