// What the sensors of a test say as long as nothing is given.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

// As plugins/robot/sensors.h says of the sensor of this name and shape; 0 or false of others.
Value RestValue(const CheckedSensor& sensor);

// The length of the step that begins or ends with `event` [s]; 0 for other events.
double RestTimeStep(EventKind event);

}  // namespace compiler
