// The loop of a run: episode after episode, each stored as soon as it is over.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/episode_warnings.h"
#include "runtime/training/run/episodes_ahead.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/recorder.h"
#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/stop_request.h"
#include "runtime/training/run/tape_recorder.h"
#include "runtime/training/run/task_modules.h"
#include "runtime/training/run/training_hooks.h"

namespace runtime {

class Training {
 public:
  // `graph`: started, with one environment, one learner and a task that pays it; throws UserError
  // where it has not. Everything passed must outlive the training.
  // `run` grows as tasks are loaded and episodes planned.
  Training(ModuleGraph& graph, const RunRecord& run, RunDatabase& database, Progress& progress,
           TrainingHooks& hooks);

  // From now on `jobs` episodes at a time, where the learner and the tasks allow that; what comes
  // of them is the same. `types` and `context`, which the graph was made of, outlive the training.
  void RunSideBySide(int jobs, const ModuleTypes& types, const Context& context);
  // Why no two episodes are run at a time whatever is asked for; "" where they can be.
  std::string WhyNotSideBySide() const { return WhyNotAhead(environment_, learner_, tasks_); }

  // Goes back to the last checkpoint (the start, if there is none): loads the modules' state and
  // deletes the episodes that came after it. They will come again, bit for bit.
  void Restore();

  // Runs the episodes that are left. Where a stop is requested, ends after the current episode;
  // returns whether all are done. Throws UserError where an episode cannot be saved.
  bool Run(const StopRequest& stop);

  int64_t episodes_done() const { return episodes_done_; }

 private:
  using Clock = std::chrono::steady_clock;

  void RunPlannedEpisodes(const StopRequest& stop);
  bool stops(const StopRequest& stop) const;
  // An episode of the run's own graph, with which somebody may do something at each time step.
  EpisodeRecord RunNextEpisode(const StopRequest& stop);
  // Who has run the next episode; null where that is for the run itself, or where it must not be
  // run any more. `has_changed` becomes true where somebody has changed the graph meanwhile.
  Collector* WaitForCollector(const StopRequest& stop, bool& has_changed);
  void Finish(const EpisodeRecord& episode, const UniversalTask& task, const Recorder& recorder,
              const TapeRecorder& tape, const StopRequest& stop);
  // Lets whoever wants to change something do so, after `step` time steps of the episode.
  // Returns whether somebody did.
  bool AllowChanges(int64_t step);
  void SaveBeforeStop(bool has_changed);
  void NoteStop(const StopRequest& stop);
  std::optional<Recording> RecordingOf(const EpisodeRecord& episode, const UniversalTask& task,
                                       const Recorder& recorder) const;
  std::optional<Checkpoint> CheckpointIfDue(bool is_last_episode);

  ModuleGraph& graph_;
  const RunRecord& run_;
  RunDatabase& database_;
  Progress& progress_;
  TrainingHooks& hooks_;
  Environment& environment_;
  Learner& learner_;
  TaskModules tasks_;
  Recorder recorder_;
  TapeRecorder tape_;
  ReturnStatistics statistics_;
  int64_t episodes_done_ = 0;
  bool stop_is_noted_ = false;
  EpisodeWarnings warnings_;
  std::unique_ptr<EpisodesAhead> ahead_;  // null: one at a time
  Clock::time_point last_checkpoint_ = Clock::now();
};

}  // namespace runtime
