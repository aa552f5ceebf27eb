// What the learner has shown of each episode.
#pragma once

#include <vector>

#include "runtime/analysis/curves/task_curves.h"

namespace runtime {

// One for each of `curves`, which no task has; its values are not numbers where there was none.
std::vector<Curve> LearnerCurves(const std::vector<CurveRecord>& curves,
                                 const std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
