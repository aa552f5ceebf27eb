// The curves of a run whose tasks may change: what has the same name in several of them is one
// curve.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// The curves of the tasks that were active, in the order in which they appeared: [{name, unit,
// reduction, doc, tasks, values}], with the indices of the tasks that have it, and a value, in
// base64, for each episode. It is not a number where the active task has no such curve. `values`
// gives one for each of the curves that `curves` says the episode's active task to have.
nlohmann::json TaskCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
                          const std::function<std::vector<CurveRecord>(const TaskRecord&)>& curves,
                          const std::function<std::vector<double>(const EpisodeRecord&)>& values);

// The terms, metrics or logs.
nlohmann::json TermCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);
nlohmann::json MetricCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);
nlohmann::json LogCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);
// The same of the phases: of each the time that it lasted, and what was paid in it.
nlohmann::json PhaseCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
