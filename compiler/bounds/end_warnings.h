// Ends that come in every step, and what is paid beside an end again and again.
#pragma once

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

void WarnOfEnds(const CheckedTask& task, const TaskBounds& bounds, Diagnostics& diagnostics);

}  // namespace compiler
