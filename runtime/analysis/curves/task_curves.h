// What a run's record says of each episode, as curves. The tasks of a run may change: what has the
// same name and unit in several of them is one curve.
#pragma once

#include <functional>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct Curve {
  CurveRecord record;
  std::vector<int64_t> tasks;  // ids of those that have it, ascending
  // One for each episode; not a number where the episode's active task has no such curve.
  std::vector<double> values;
};

// The curves of the tasks that were active, in the order in which they appeared. `values` gives one
// for each of the curves that `curves` says the episode's active task to have.
std::vector<Curve> TaskCurves(
    const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
    const std::function<std::vector<CurveRecord>(const TaskRecord&)>& curves,
    const std::function<std::vector<double>(const EpisodeRecord&)>& values);

// The terms, metrics or logs.
std::vector<Curve> TermCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);
std::vector<Curve> MetricCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);
std::vector<Curve> LogCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);
// Of each phase the time that it lasted, and what was paid in it.
std::vector<Curve> PhaseCurves(const RunRecord& run, const std::vector<EpisodeRecord>& episodes);

}  // namespace runtime
