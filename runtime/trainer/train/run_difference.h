#pragma once

#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// In what two runs differ that can only be runs of one experiment where they are alike, in words:
// "the text of the task", "`learner.temperature` is 1.0 there and 5.0 here". None where they are
// alike. Throws UserError where an agent cannot be read.
std::vector<std::string> DifferencesOf(const RunRecord& there, const RunRecord& here);

}  // namespace runtime
