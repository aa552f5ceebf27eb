#pragma once

#include <taskc/host.h>
#include <taskc/largest_reward.h>

#include <cmath>
#include <string>
#include <vector>

#include "plugins/host/task_episode.h"

namespace libtaskc {

// One episode of an instance after another: what was paid, and how it has ended. Who owns it keeps
// the sensors up to date. Allocates only in the constructor.
class Episode {
 public:
  explicit Episode(const taskc_plugin& task);

  host::TaskFrame& frame() { return task_.frame(); }
  const host::TaskFrame& frame() const { return task_.frame(); }
  const host::TaskEpisode& counts() const { return task_; }

  // Gives memory its initial values, which depend on the params, unless that has been done.
  void Initialize();
  // Forgets what was paid, and tells the task; its sensors show the first state.
  taskc_result Start(taskc_uint64 seed);
  // One within the episode. After the end of a time step, Measure() where needs_measuring().
  taskc_result Call(int event, double time_step) {
    if (event == TASKC_END_OF_TIME_STEP) task_.NoteTimeStep(time_step);
    if (!frame().Call(event, time_step)) return {0, -1, -1, -1};
    return Note();
  }
  // The ends of as many time steps as rows from `row` to `end`, unless the episode is over before.
  // Each time `show(row)` brings the sensors up to date, and `note(row, reward)` hears what was
  // paid. Gives back the row after the last. Precondition: the task has something to do then, and
  // the episode is not over.
  template <class Show, class NoteRow>
  taskc_int64 EndTimeSteps(taskc_int64 row, taskc_int64 end, double time_step, Show show,
                           NoteRow note) {
    const taskc_event_function function = frame().plugin().events[TASKC_END_OF_TIME_STEP];
    task_.NoteTimeStep(time_step);
    const taskc_frame& done = frame().frame();
    while (row < end) {
      show(row);
      function(frame().Next(time_step));
      if (HasOnlyPaid(done)) {
        return_ += done.reward;
        note(row++, done.reward);
        continue;
      }
      note(row++, NoteIncident().reward);
      if (is_over()) break;
    }
    return row;
  }
  bool needs_measuring() const { return task_.needs_measuring(); }
  void Measure() { task_.MeasureTimeStep(); }
  // Before the sensors of TASKC_MEASURE are brought up to date, and Finish().
  taskc_result End(taskc_int32 outcome);
  // Completes metrics and logs.
  void Finish() { task_.End(); }

  bool is_running() const { return is_running_; }
  bool is_over() const { return kind_ >= 0; }
  double episode_return() const { return return_; }
  taskc_int64 fault_count() const { return fault_count_; }
  taskc_int32 kind() const { return kind_; }            // -1: nothing has ended it
  taskc_int32 end() const { return end_; }              // -1: no end of the task
  taskc_int32 violation() const { return violation_; }  // -1: no requirement
  // Null while nothing has ended it; "" where the host has.
  const char* reason() const;

 private:
  // Mostly, a call has paid something, and that is all.
  static bool HasOnlyPaid(const taskc_frame& done) {
    return (done.end & done.violation & done.fault) == -1 &&
           std::abs(done.reward) <= TASKC_LARGEST_REWARD;
  }
  // What the last call has done.
  taskc_result Note() {
    const taskc_frame& done = frame().frame();
    if (!HasOnlyPaid(done)) return NoteIncident();
    return_ += done.reward;
    return {done.reward, -1, -1, -1};
  }
  taskc_result NoteIncident();

  host::TaskEpisode task_;
  std::vector<std::string> violation_reasons_;  // one for each requirement
  bool is_initialized_ = false;
  bool is_running_ = false;
  double return_ = 0;
  taskc_int64 fault_count_ = 0;
  taskc_int32 kind_ = -1;
  taskc_int32 end_ = -1;
  taskc_int32 violation_ = -1;
};

}  // namespace libtaskc
