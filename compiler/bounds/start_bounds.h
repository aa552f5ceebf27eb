// Whether what a start draws keeps every joint within its stops.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Reports the joints that can start beyond a stop, whatever the params.
void CheckStops(const CheckedTask& task, Diagnostics& diagnostics);

}  // namespace compiler
