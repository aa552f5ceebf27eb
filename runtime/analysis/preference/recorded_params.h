#pragma once

#include <map>
#include <string>

#include "runtime/training/run/run_records.h"

namespace runtime {

// A param of the task with which a run began.
struct RecordedParam {
  enum class Kind { kReal, kWhole, kCondition };

  double value = 0;  // in the unit that the task declares; a condition is 1 or 0
  Kind kind = Kind::kReal;
};

// By their names. Throws UserError where the run's agent has no such task.
std::map<std::string, RecordedParam> RecordedParams(const RunRecord& run);

}  // namespace runtime
