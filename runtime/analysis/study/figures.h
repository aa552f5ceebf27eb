// The results of a study as plain figures: `trainer report DIR --json`, and what its page shows.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/analysis/study/results.h"

namespace runtime {

// What docs/trainer.md describes, but for "curve".
nlohmann::ordered_json Figures(const ExperimentResult& result, const Sentences& sentences);

// {"episodes": [...], "mean": [...], "low": [...], "high": [...]}
nlohmann::ordered_json CurveFigures(const Curves& curves);

}  // namespace runtime
