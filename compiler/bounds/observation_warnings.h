// Warnings of what a task observes.
#pragma once

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/source/sources.h"

namespace compiler {

// Of what is always the same, and, where the task observes onboard, of what a real robot cannot
// sense, directly or through memory.
void WarnOfObservations(const CheckedTask& task, const Sources& sources, const TaskBounds& bounds,
                        Diagnostics& diagnostics);

}  // namespace compiler
