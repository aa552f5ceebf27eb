// What the learner has shown of each episode.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// [{name, unit, doc, values}], with a value, in base64, for each episode; not a number where there
// was none.
nlohmann::json LearnerCurves(const std::vector<CurveRecord>& curves,
                             const std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
