// What the robot was told, beside a replay.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/training/run/run_records.h"

namespace runtime {

// In the order of time: [{time [s], name, type, unit, value}]; the value is a list of numbers.
nlohmann::json GoalsTold(const TaskRecord& task, const Evaluation& evaluation);

}  // namespace runtime
