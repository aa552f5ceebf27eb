// A run trained again from its record, and compared with it episode by episode.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/trainer/reproduce/episode_difference.h"
#include "runtime/trainer/reproduce/rebuilt_run.h"
#include "runtime/training/run/machine.h"
#include "runtime/training/run/progress.h"

namespace runtime {

struct ReproduceOptions {
  std::filesystem::path folder;
  std::optional<int64_t> episodes;  // the first ones; nothing: all that are recorded
  Plugins plugins = Plugins::kRebuilt;
  int jobs = 0;                                 // as of SessionOptions
  ProgressStyle style = ProgressStyle::kQuiet;  // how it is shown while it trains
};

// What of a machine, or of what a task was compiled by, is in the record, and what it is here.
struct CauseComparison {
  std::string name;
  std::string recorded;  // "" where the record does not say
  std::string here;
  bool is_equal() const { return recorded == here; }
};

struct Reproduction {
  std::string name;                            // of the run's folder
  int64_t episodes = 0;                        // to be compared
  int64_t equal = 0;                           // that are, from the first on
  int64_t changes = 0;                         // made live, which were repeated
  int stop_signal = 0;                         // 0: it came to its end
  std::vector<ValueDifference> differences{};  // in episode `equal` + 1; none: all are equal
  // Whether what is learned in the end is equal as well; nothing where the record does not have it.
  std::optional<bool> is_state_equal{};
  std::vector<CauseComparison> causes{};
  std::string taken_back{};  // what cannot be repeated and may explain the difference; "" for none

  bool is_equal() const { return differences.empty() && is_state_equal.value_or(true); }
};

// Throws UserError, or CallError where the run has fewer episodes.
Reproduction ReproduceRun(const ReproduceOptions& options);

}  // namespace runtime
