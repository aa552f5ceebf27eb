#pragma once

#include <string>

#include "plugins/robot/sensors.h"
#include "runtime/core/module/sensor_data.h"

namespace runtime {

// An in port for one of the robot's sensors, with its name.
inline SensorIn MakeSensorIn(Module* owner, robot::SensorId id) {
  const robot::SensorDescription& sensor = robot::Sensors()[static_cast<size_t>(id)];
  return SensorIn(owner, std::string(sensor.name), SensorTypeText(sensor.type, sensor.unit));
}

}  // namespace runtime
