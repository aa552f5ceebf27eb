// What a task's bounds say about it: conditions that never hold, terms too small or without bound,
// rewards that teach something else than was meant.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Looks at a task without errors.
void WarnOfBounds(const CheckedTask& task, Diagnostics& diagnostics);

}  // namespace compiler
