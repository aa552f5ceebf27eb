// Which sensors a task reads, and when: the runtime senses nothing else.
#pragma once

#include "compiler/check/checked_task.h"

namespace compiler {

// Takes a task whose `sensors` are all that it could read. Sets `read_by` of each, and drops those
// that nothing reads.
void KeepReadSensors(CheckedTask& task);

}  // namespace compiler
