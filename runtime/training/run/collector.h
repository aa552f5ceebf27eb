// Runs single episodes for a run, in a copy of its graph.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>

#include "runtime/core/module/module_graph.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/episode_watcher.h"
#include "runtime/training/run/recorder.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/tape_recorder.h"
#include "runtime/training/run/task_modules.h"

namespace runtime {

// Belongs to the thread that trains; but while Run() is running, in whatever thread, to that one.
class Collector {
 public:
  // `graph`: as CopyOf() gives it. `watcher`: null, or one that outlives this object.
  explicit Collector(ModuleGraph graph, EpisodeWatcher* watcher = nullptr);

  // The next episode to run is number `episode`, and goes as it would in `graph`, of which the
  // collector's is a copy, with `leader` for a learner.
  void Prepare(int64_t episode, const ModuleGraph& graph, const Learner& leader);
  // Runs the episode to its end, or until it `is_unwanted`: then there is no result.
  void Run(const std::atomic<bool>& is_unwanted);

  int64_t episode() const { return episode_; }
  ModuleGraph& graph() { return graph_; }

  // Of the episode that was run to its end.

  // Lets the modules of `graph` take it over, and returns its record. Throws what was thrown in it.
  EpisodeRecord HandOver(const ModuleGraph& graph, Learner& leader);
  const UniversalTask& task() const { return *tasks_.active; }
  const Recorder& recorder() const { return recorder_; }
  const TapeRecorder& tape() const { return tape_; }

 private:
  ModuleGraph graph_;
  Environment& environment_;
  Learner& learner_;
  TaskModules tasks_;
  EpisodeWatcher* watcher_;
  Recorder recorder_;
  TapeRecorder tape_;
  int64_t episode_ = 0;
  EpisodeRecord record_;
  std::exception_ptr failure_;
};

}  // namespace runtime
