// Tasks in which an agent does best to fail at once.
#pragma once

#include "compiler/bounds/bounds.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Where living only costs, a failure that costs nothing is the cheapest way out.
void WarnOfEarlyDeath(const CheckedTask& task, const TaskBounds& bounds, Diagnostics& diagnostics);

}  // namespace compiler
