// Warnings of what rewards and ends depend on and the agent does not see.
#pragma once

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/source/sources.h"

namespace compiler {

// Memory that grows through the whole run, and hidden memory. Where the task says what the learner
// sees, goals, phases and functions of the past as well, and nothing that an observation shows.
void WarnOfMemory(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
                  Diagnostics& diagnostics);

}  // namespace compiler
