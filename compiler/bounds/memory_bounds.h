// The values that a task's memory can have between two callbacks.
#pragma once

#include <vector>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"

namespace compiler {

// What each event finds at its start, but for its memory.
Values ValuesAtStart(const CheckedTask& task, EventKind event, const Assumptions& assumptions);

// For all sequences of events: the smallest bounds that hold at first and that no callback leaves,
// or nearly so where there is no end to what they grow by.
std::vector<Box> MemoryBounds(const CheckedTask& task, const Assumptions& assumptions);

}  // namespace compiler
