// What a version of a task changed.
#pragma once

#include <string>

#include "runtime/training/run/run_records.h"

namespace runtime {

// What differs in meaning between two tasks of a run, as `taskc diff` says it, line by line. From
// the texts that the run keeps, so it does not matter what has become of their files. Empty where
// the two mean the same, or cannot be compared: a plugin that no compiler of ours has built has no
// text that could be. Throws UserError where nothing can be written for that.
std::string VersionDifference(const RunRecord& run, const TaskRecord& before,
                              const TaskRecord& after);

}  // namespace runtime
