// Numbers as the elements of a task's sensors, memory and goals have them.
#pragma once

#include <taskc/plugin.h>

#include <cstddef>

namespace host {

// `scalar`: TASKC_BOOL, TASKC_INT or TASKC_REAL. A bool is 0 or 1.
double LoadScalar(const std::byte* place, taskc_int32 scalar);
void StoreScalar(std::byte* place, taskc_int32 scalar, double value);

}  // namespace host
