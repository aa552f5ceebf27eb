// What the robot was told, as curves over the episodes and beside a replay.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// One curve for each element of each goal of the tasks that were active, in the form of
// TermCurves() (task_curves.h): of each episode the mean over its time.
nlohmann::json GoalCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);

// What the robot was told in an episode, in the order of time: [{time [s], name, type, unit,
// value}]; the value is a list of numbers.
nlohmann::json GoalsTold(const TaskRecord& task, const Evaluation& evaluation);

}  // namespace runtime
