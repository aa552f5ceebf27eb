// What a run has learned, to be put to use without learning on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/scratch_folder.h"
#include "runtime/trainer/runs/kept_run.h"
#include "runtime/training/run/episode.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {

// A run up to its last checkpoint, also while it is being trained.
struct LearnedRun {
  // `purpose`: what a run without a checkpoint is not good for, "to evaluate". Throws UserError.
  LearnedRun(const std::filesystem::path& folder, const RunDatabase& database, const char* purpose);

  Checkpoint checkpoint;
  RunRecord record;
  std::vector<EpisodeRecord> episodes;
};

// The learner with all that its run had learned, in the robot's environment of any profile.
class Performer {
 public:
  // `run` and `database` are of `folder`, and not needed afterwards. Throws UserError.
  Performer(const std::filesystem::path& folder, LearnedRun& run, RunDatabase& database,
            const std::string& profile, Progress& progress, const StopRequest& stop,
            const ModuleTypes& types);

  EpisodeRecord RunEpisode(int64_t number, const AfterStep& after_step) {
    return runtime::RunEpisode(number, {environment_, learner_, tasks_}, after_step);
  }

  const KeptRun& kept() const { return kept_; }
  const Environment& environment() const { return environment_; }
  Learner& learner() { return learner_; }

 private:
  const ScratchFolder scratch_;
  KeptRun kept_;
  Environment& environment_;
  Learner& learner_;
  TaskModules tasks_;
};

}  // namespace runtime
