// Which sensors a task reads, and when: the runtime senses nothing else.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Takes a task whose `sensors` are all that it could read. Sets `read_by` of each, and drops those
// that neither event nor metric reads: no test may expect anything of them, and what a test gives
// them is dropped, with a warning.
void KeepReadSensors(CheckedTask& task, Diagnostics& diagnostics);

}  // namespace compiler
