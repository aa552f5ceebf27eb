// Tasks in which an agent does best to fail at once.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Where going on only costs, a failure that costs less is the best way out. Judged with the params
// as they begin.
void WarnOfEarlyDeath(const CheckedTask& task, Diagnostics& diagnostics);

}  // namespace compiler
