#include "compiler/task_tests/rest_values.h"

#include "plugins/robot/sensors.h"

namespace compiler {

// A task that declares its own sensors may give them the names and shapes of a robot's.
Value RestValue(const CheckedSensor& sensor) {
  const robot::SensorDescription* known = robot::FindSensor(sensor.name);
  const Type& type = sensor.type;
  if (sensor.at_rest.size() == type.size()) return sensor.at_rest;
  const size_t length = type.shape == Shape::kArray ? type.columns : type.size();
  if (known == nullptr || type.scalar != Scalar::kReal || known->at_rest.size() != length)
    return Filled(type.scalar, type.size(), 0);
  Reals elements;
  for (size_t i = 0; i < type.size(); ++i) elements.push_back(known->at_rest[i % length]);
  return elements;
}

double RestTimeStep(EventKind event) {
  switch (event) {
    case EventKind::kStartOfTimeStep:
    case EventKind::kEndOfTimeStep:
      return 0.005;
    case EventKind::kStartOfPhysicsStep:
    case EventKind::kEndOfPhysicsStep:
      return 0.0002;
    default:
      return 0;
  }
}

}  // namespace compiler
