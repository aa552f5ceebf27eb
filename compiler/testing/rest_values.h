// What the sensors of a test say as long as nothing is given.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/evaluate/value.h"

namespace compiler {

// 0 or false, but for the base's attitude: it stands upright, its axes along the world's.
Value RestValue(const CheckedSensor& sensor);

// The length of the step that begins or ends with `event` [s]; 0 for other events.
double RestTimeStep(EventKind event);

}  // namespace compiler
