// What every host counts of an episode, beside what the task computes.
#pragma once

#include <taskc/largest_reward.h>
#include <taskc/plugin.h>

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "plugins/host/metric_reducer.h"
#include "plugins/host/task_frame.h"

namespace host {

// What one event has done. Numbers are indices into the plugin's tables, or -1.
struct EventOutcome {
  double reward = 0;           // 0 where the sum is not finite, or too large to be paid
  bool is_paid = true;         // false: such a sum
  taskc_int32 fault = -1;      // of the first term that could not be paid
  taskc_int32 violation = -1;  // of the first requirement that did not hold
  taskc_int32 end = -1;        // of the first end that was reached
};

// A TaskFrame and its episode. Who owns it keeps the sensors' data up to date. Nothing here
// allocates but the constructor.
class TaskEpisode {
 public:
  // `plugin`: as for TaskFrame.
  explicit TaskEpisode(const taskc_plugin& plugin);

  TaskFrame& frame() { return frame_; }
  const TaskFrame& frame() const { return frame_; }

  // Forgets what was paid, logged and measured.
  void Start();
  // Tells the task of an event; nothing where it has no function for it.
  std::optional<EventOutcome> Call(int event, double time_step) {
    if (!frame_.Call(event, time_step)) return std::nullopt;
    return Outcome();
  }
  // What the last event has done.
  EventOutcome Outcome() const {
    const taskc_plugin& plugin = frame_.plugin();
    const taskc_frame& frame = frame_.frame();
    const bool is_paid = std::abs(frame.reward) <= TASKC_LARGEST_REWARD;
    return {.reward = is_paid ? frame.reward : 0,
            .is_paid = is_paid,
            .fault = IndexOrNone(frame.fault, plugin.term_count),
            .violation = IndexOrNone(frame.violation, plugin.requirement_count),
            .end = IndexOrNone(frame.end, plugin.end_count)};
  }
  // At the end of each time step, before its event: how long it was.
  void NoteTimeStep(double time_step) { time_step_ = time_step; }
  // After that event, where needs_measuring().
  bool needs_measuring() const { return reducer_.needs_time_steps(); }
  void MeasureTimeStep();
  // What the frame's metrics are between two time steps, to look at: counts for nothing.
  void Measure();
  // After the event at the end of the episode: metrics() and logs() are complete.
  void End();

  // One for each metric, and one for each log (log_value.h).
  std::span<const double> metrics() const { return reducer_.values(); }
  std::span<const double> logs() const { return logged_; }

  // In the middle of an episode: metric number `index` goes on from number `other_index` of
  // `other`, which has the same reduction.
  void TakeOverMetric(size_t index, const TaskEpisode& other, size_t other_index) {
    reducer_.TakeOver(index, other.reducer_, other_index);
  }
  void TakeOverTimeStep(const TaskEpisode& other) { time_step_ = other.time_step_; }

 private:
  // What stands for no entry of the table would be a damaged plugin's.
  static taskc_int32 IndexOrNone(taskc_int32 index, taskc_uint32 count) {
    return index >= 0 && static_cast<taskc_uint32>(index) < count ? index : -1;
  }

  TaskFrame frame_;
  MetricReducer reducer_;
  std::vector<double> logged_;
  double time_step_ = 0;  // [s] of the last one; 0 before it
};

}  // namespace host
