// Warnings about the phases of a task: those that are never reached, those that never end, and
// circles that pay without any progress.
#pragma once

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

void WarnOfPhases(const CheckedTask& task, const TaskBounds& bounds, Diagnostics& diagnostics);

}  // namespace compiler
