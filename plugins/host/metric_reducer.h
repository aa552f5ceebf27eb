#pragma once

#include <taskc/plugin.h>

#include <cstdint>
#include <span>
#include <vector>

namespace host {

// One number per episode from what each metric was at its time steps: the last, the sum, the
// largest, the smallest or the mean. A value that is not a number makes the whole episode's not a
// number, and so do `max`, `min` and `mean` of an episode without a time step.
class MetricReducer {
 public:
  explicit MetricReducer(std::span<const taskc_metric> metrics);

  // Whether some metric has to be measured at the end of each time step; `last` needs only the end
  // of the episode.
  bool needs_time_steps() const { return needs_time_steps_; }

  void StartEpisode();
  // `measured`: one value for each metric.
  void EndTimeStep(std::span<const double> measured);
  void EndEpisode(std::span<const double> measured);

  // In the middle of an episode: metric number `index` continues from what `other` has of its
  // metric number `other_index`, which has the same reduction.
  void TakeOver(size_t index, const MetricReducer& other, size_t other_index);

  // One for each metric; complete after EndEpisode().
  std::span<const double> values() const { return values_; }

 private:
  std::vector<int> reductions_;  // TASKC_LAST ... TASKC_MEAN
  std::vector<double> values_;
  std::vector<int64_t> time_steps_;  // that each value is made of
  bool needs_time_steps_ = false;
};

}  // namespace host
