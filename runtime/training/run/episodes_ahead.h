// Which episodes of a run are run before their turn, side by side.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module_graph.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/collector_pool.h"
#include "runtime/training/run/task_modules.h"
#include "runtime/training/run/training_hooks.h"

namespace runtime {

// An episode follows from what the learner acts by, the task with its params, the seed of the run
// and the episode's number. So it can be run before those before it are over, as long as these
// change nothing of that; if they do after all, it is run again. How many are run ahead decides how
// long a run takes, and nothing else.
class EpisodesAhead {
 public:
  // `graph` of the run, with its `learner`; `jobs` at a time, at least 2. All of these outlive this
  // object.
  EpisodesAhead(const ModuleGraph& graph, const ModuleTypes& types, const Context& context,
                Learner& learner, TrainingHooks& hooks, int jobs);

  // Starts what can be run ahead of the episode `next` and up to `last`. Returns who runs `next`;
  // null where that is for the run itself.
  Collector* Plan(int64_t next, int64_t last, const TaskModules& tasks);
  // Whether it is done by now; waits a little for that.
  bool IsDone(const Collector& collector);
  // The learner takes over what the collector has, which is free then.
  EpisodeRecord TakeOver(Collector& collector);
  void Free(const Collector& collector) { pool_.Free(collector); }
  // Somebody has changed the graph.
  void StartOver() { pool_.Renew(); }

 private:
  void Start(int64_t episode, Collector& collector);

  const ModuleGraph& graph_;
  Learner& learner_;
  const TrainingHooks& hooks_;
  int64_t policy_number_;
  CollectorPool pool_;
};

// Why episodes of these cannot be run ahead, as a sentence; "" where they can.
std::string WhyNotAhead(const Environment& environment, const Learner& learner,
                        const TaskModules& tasks);

}  // namespace runtime
