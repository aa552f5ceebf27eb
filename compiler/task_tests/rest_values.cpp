#include "compiler/task_tests/rest_values.h"

#include "plugins/robot/sensors.h"

namespace compiler {

// A task that declares its own sensors may give them the names and shapes of a robot's.
Value RestValue(const CheckedSensor& sensor) {
  const robot::SensorDescription* known = robot::FindSensor(sensor.name);
  const bool is_known = known != nullptr && sensor.type.scalar == Scalar::kReal &&
                        sensor.type.size() == known->at_rest.size();
  if (is_known) return Reals(known->at_rest.begin(), known->at_rest.end());
  return Filled(sensor.type.scalar, sensor.type.size(), 0);
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
