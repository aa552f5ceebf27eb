// What a task, or a state, can sense of a robot in a world, and of the things there.
#pragma once

#include <deque>

#include "plugins/robot/robot_description.h"
#include "plugins/robot/sensors.h"
#include "plugins/world/thing_sensors.h"
#include "runtime/training/simulation/lazy_sensor.h"
#include "runtime/training/simulation/randomization.h"

namespace runtime {

// One of the list of the robot's sensors.
class RobotSensor : public LazySensor {
 public:
  RobotSensor(const SensorMoment& moment, const robot::SensorDescription& description,
              const robot::RobotDescription& robot);

  const robot::SensorDescription& description() const { return *description_; }

 private:
  void Compute() override;
  void AddNoise();

  const robot::SensorDescription* description_;
};

// One of a thing of the world.
class ThingSensor : public LazySensor {
 public:
  ThingSensor(const SensorMoment& moment, world::ThingSensor description,
              const robot::RobotDescription& robot);

  const world::ThingSensor& description() const { return description_; }

 private:
  void Compute() override;
  void ComputeFixed(const world::Thing& thing);

  world::ThingSensor description_;
};

// The memory of all sensors stays where it is as long as this object lives.
class RobotSensors {
 public:
  // `around`: the robot's world, or null.
  RobotSensors(const robot::RobotDescription& robot, const world::WorldDescription* around);
  RobotSensors(const RobotSensors&) = delete;
  RobotSensors& operator=(const RobotSensors&) = delete;

  std::deque<RobotSensor>& sensors() { return sensors_; }
  std::deque<ThingSensor>& thing_sensors() { return thing_sensors_; }

  // From now on the sensors show `world`, `time` seconds after the start of the episode. To be
  // called whenever the world has changed; `world` must stay until the next call.
  void Refresh(const World& world, double time);
  // What is added to sensors from the next Refresh() on.
  void SetNoise(const Randomization::Noise& noise, const EpisodeRandom& random);
  // From now on the sensors show what they showed when they were last read.
  void Freeze();
  // Between the two, reading a sensor gives what it always gives and leaves no trace: it does not
  // count for Freeze().
  void StartPeek() { moment_.is_peeking = true; }
  void EndPeek();

 private:
  SensorMoment moment_;
  std::deque<RobotSensor> sensors_;
  std::deque<ThingSensor> thing_sensors_;
};

}  // namespace runtime
