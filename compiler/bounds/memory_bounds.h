// The values that a task's memory can have between two callbacks.
#pragma once

#include <vector>

#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"

namespace compiler {

// What each event finds at its start, but for its memory. What has no range is taken to be smaller
// than `without_range`.
Values ValuesAtStart(const CheckedTask& task, EventKind event, double without_range);

// For all sequences of events: the smallest bounds that hold at first and that no callback leaves,
// or nearly so where there is no end to what they grow by.
std::vector<Box> MemoryBounds(const CheckedTask& task, double without_range);

}  // namespace compiler
