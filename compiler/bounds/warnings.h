// What a task's bounds say about it: conditions that never hold, terms too small or without bound,
// rewards that teach something else than was meant.
#pragma once

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/source/sources.h"

namespace compiler {

// Looks at a task without errors, whose text and bounds these are.
void WarnOfBounds(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
                  Diagnostics& diagnostics);

}  // namespace compiler
