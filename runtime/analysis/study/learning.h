// What the episodes of a run say about how it learned.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// Over how many episodes means are taken in a run of this many planned ones: a twentieth of them,
// at most 50.
int64_t MeanWindow(int64_t episodes_planned);

// For each value the mean of the last `window` up to it, of as many as there are. Values that are
// not numbers are left out.
std::vector<double> MovingAverage(std::span<const double> values, int64_t window);
// The same of the returns.
std::vector<double> MovingAverage(std::span<const EpisodeRecord> episodes, int64_t window);

// At which a run had most of what it learned.
struct MostLearned {
  int64_t episode = 0;
  double cpu_seconds = 0;  // spent up to there
};

// Where the moving average of the returns had come 80 % of the way from its first full window to
// the last one, for the first time. Nothing for a run shorter than two windows, and for one that
// did not get better by more than chance: by three standard errors of the difference between two
// such averages, of returns that vary as much as each does from the one before it.
std::optional<MostLearned> FindMostLearned(std::span<const EpisodeRecord> episodes, int64_t window);

// Means over the last `window` episodes by name, of the active tasks' terms and metrics. What was
// never a number is missing.
struct FinalMeans {
  double episode_return = 0;
  std::map<std::string, double> terms;
  std::map<std::string, double> metrics;
};

// `episodes`: those of `run`, at least one.
FinalMeans MeansAtTheEnd(const RunRecord& run, std::span<const EpisodeRecord> episodes,
                         int64_t window);

}  // namespace runtime
