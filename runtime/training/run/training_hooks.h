// How someone from outside takes part in a training.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "runtime/core/module/module_graph.h"
#include "runtime/training/run/episode_watcher.h"
#include "runtime/training/run/return_statistics.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// All of it is called on the thread that trains; what is done to the watcher, on those that run
// episodes.
class TrainingHooks {
 public:
  virtual ~TrainingHooks() = default;

  // Before the modules' state after episode `episode` is read (0: there is none): what was changed
  // up to then must be changed again. Returns the modules of which the state may have another
  // opinion whether they are there.
  virtual std::set<std::string> BeforeRestore(int64_t episode) = 0;

  // With the returns of all episodes that the run continues from.
  virtual void AfterRestore(const ReturnStatistics& statistics) = 0;

  // Where nothing of the run is running: before the first step of episode `episode` (`step` is 0,
  // any number of times), and after each of its time steps, unless it is run ahead. May change the
  // graph; returns whether it did.
  virtual bool AtSafePoint(int64_t episode, int64_t step) = 0;
  // The last episode that nobody means to take part in, nor in those before it from now on: up to
  // there they may be run ahead.
  virtual int64_t undisturbed_until() const = 0;
  // Makes `copy`, a copy of the graph as it is now (CopyOf()), what the graph would be for episode
  // `episode`, which is to come, as far as that is planned.
  virtual void Anticipate(int64_t episode, ModuleGraph& copy) const = 0;

  // Null where nobody ever watches.
  virtual EpisodeWatcher* watcher() { return nullptr; }

  virtual void AfterEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics,
                            bool checkpoint_was_saved) = 0;
  virtual void OnWarning(const std::string& text) = 0;

  // Looked at when an episode is over.
  virtual bool wants_checkpoint() const = 0;
  virtual bool wants_stop() const = 0;

  // All planned episodes are done. May wait until there are more; returns whether there are.
  virtual bool PlanMore(int64_t episodes_done) = 0;
};

}  // namespace runtime
