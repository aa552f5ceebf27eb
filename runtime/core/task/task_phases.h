#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <span>
#include <vector>

#include "plugins/host/task_frame.h"

namespace runtime {

// What an episode was like in one phase.
struct PhaseSums {
  double time = 0;    // [s] that it has lasted, in all its passes
  double reward = 0;  // what was paid in it
  bool operator==(const PhaseSums&) const = default;
};

// The phases of one instance of a task, and what each was in the current episode. A task without
// phases has none, and nothing is noted.
class TaskPhases {
 public:
  // Refers to `host`, which must outlive this.
  explicit TaskPhases(host::TaskFrame& host);

  // Before the event at the start of an episode.
  void StartEpisode();
  // At the end of each time step, before its event.
  void AddTime(double time_step) {
    if (!phases_.empty()) sums_[present()].time += time_step;
  }
  // After an event before which `phase` was the present one.
  void AddReward(size_t phase, double reward) {
    if (!phases_.empty()) sums_[phase].reward += reward;
  }

  std::span<const taskc_phase> phases() const { return phases_; }
  // The number of the present one. 0 where there are none.
  size_t present() const;
  // Of the current episode, one for each.
  const std::vector<PhaseSums>& sums() const { return sums_; }

  // Goes on in the episode of `old`, whose memory the host has taken over: in the phase of the same
  // name, or else in the first, from its beginning.
  void TakeOver(const TaskPhases& old);

 private:
  void Begin(size_t phase);

  host::TaskFrame& host_;
  std::span<const taskc_phase> phases_;
  std::vector<PhaseSums> sums_;
};

}  // namespace runtime
