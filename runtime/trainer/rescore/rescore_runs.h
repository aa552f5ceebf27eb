// The recorded episodes of runs, judged by another task.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/task/plugin.h"
#include "runtime/trainer/rescore/rank_correlation.h"
#include "runtime/trainer/rescore/rescored_episode.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {

struct RescoredRun {
  std::string name;
  std::string task;  // the one that it was trained in
  std::string profile;
  std::vector<RescoredEpisode> episodes;
  std::vector<std::string> left_out;  // why an episode was: a sentence each

  // Means over its episodes; at least one.
  double recorded_return() const;
  double new_return() const;
};

// Throws UserError where the run has no episode that can be simulated again, or where the task does
// not fit its robot. Of a run that is being trained those that are there by now.
// `episode`: only this one, which must be recorded; 0: all that are.
RescoredRun RescoreRun(const std::filesystem::path& folder, const std::string& name,
                       const std::shared_ptr<const Plugin>& new_task, int64_t episode,
                       const StopRequest& stop);

// Over the episodes of a run, and over the runs.
RankCorrelation OrderOf(const RescoredRun& run);
RankCorrelation OrderOf(const std::vector<RescoredRun>& runs);

}  // namespace runtime
