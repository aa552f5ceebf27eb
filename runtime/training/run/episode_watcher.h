#pragma once

#include <atomic>
#include <cstdint>

#include "runtime/training/run/episode.h"

namespace runtime {

// Sees episodes while they are run, on whatever threads that happens: the run's own, and those of
// its collectors. Changes nothing of them.
class EpisodeWatcher {
 public:
  virtual ~EpisodeWatcher() = default;

  // To be called by who runs an episode, when it has started (`steps` is 0) and after each time
  // step. While nobody watches, that is a look at one number.
  void AfterStep(int64_t episode, int64_t steps, const EpisodeModules& modules) {
    if (is_watching_.load(std::memory_order_relaxed)) Look(episode, steps, modules);
  }
  // No more time steps of the episode that runs with this environment, before its end.
  virtual void BreakOff(const Environment& environment) = 0;

 protected:
  virtual void Look(int64_t episode, int64_t steps, const EpisodeModules& modules) = 0;
  // Any thread.
  void SetWatching(bool is_watching) { is_watching_ = is_watching; }

 private:
  std::atomic<bool> is_watching_ = false;
};

}  // namespace runtime
