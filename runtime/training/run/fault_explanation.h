// Where a reward that is not finite comes from: which part of its expression, and what that read.
#pragma once

#include <string>

#include "runtime/core/task/fault_state.h"
#include "runtime/core/task/plugin.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// What `taskc fault` computes again: the state as JSON. Numbers have all their bits; what is no
// number is a text ("nan", "inf", "-inf").
std::string FaultText(const taskc_plugin& plugin, const FaultState& state);

// "`1 / (steps - 5)` (faulty.task:8:39) is infinity, where `(steps - 5)` is 0", found by `taskc`
// from the texts in the run's record; "" where it cannot be found, as for a plugin that is not of
// its text. Takes some ten milliseconds.
std::string ExplainFault(const RunRecord& run, int64_t task, const taskc_plugin& plugin,
                         const FaultState& state);

}  // namespace runtime
