// What the robot was told, as curves over the episodes.
#pragma once

#include <vector>

#include "runtime/analysis/curves/task_curves.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// One curve for each element of each goal of the tasks that were active: of each episode the mean
// over its time.
std::vector<Curve> GoalCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
