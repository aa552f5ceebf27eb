// The weights that preferences led to, as a task to train.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/analysis/study/preference_fit.h"

namespace runtime {

struct WeightsFile {
  std::filesystem::path file;  // .task
  std::filesystem::path
      base;                // the task that it extends; empty: the one that the runs were built of
  bool is_forced = false;  // may replace a file
};

// Returns the files that were written. `study`: its name. Throws UserError, also where the base is
// not the task that the runs learned.
std::vector<std::filesystem::path> WriteWeights(const PreferenceFit& fit, const std::string& study,
                                                const WeightsFile& target);

// That trains `task` as the experiment was trained: as many runs, from the same seeds.
std::string NextCommand(const ExperimentResult& experiment, const std::filesystem::path& task);

}  // namespace runtime
