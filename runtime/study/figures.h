// The results of a study as plain figures: `trainer report DIR --json`, and what its page shows.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/study/results.h"

namespace runtime {

// {"name", "task", "task_file", "task_hash", "robot", "profile", "version", "mean_over", "runs":
// [{...}], "final_return": {...}, "best_return", "episodes_to_80_percent",
// "cpu_minutes_to_80_percent", "cpu_minutes", "metrics": [{...}], "terms": [{...}], "groups":
// [{...}]}, see docs/trainer.md. An estimate is {"count", "mean", "low", "high", "least",
// "greatest"}.
nlohmann::ordered_json Figures(const ExperimentResult& result, const Sentences& sentences);

// {"episodes": [...], "mean": [...], "low": [...], "high": [...]}
nlohmann::ordered_json CurveFigures(const Curves& curves);

}  // namespace runtime
