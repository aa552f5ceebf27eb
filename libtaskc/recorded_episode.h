#pragma once

#include <taskc/host.h>

#include "libtaskc/episode.h"
#include "libtaskc/sensor_rows.h"
#include "libtaskc/sensor_sources.h"

namespace libtaskc {

// One recorded episode, and what a task pays for it.
class RecordedEpisode {
 public:
  // `like` gives the params, the discount and the held goals. Both outlive this. Throws Failure for
  // a recording that is not one, or lacks a sensor.
  RecordedEpisode(const taskc_plugin& task, const Episode& like, const taskc_recording& recording);

  // Once. Allocates nothing.
  void Evaluate(taskc_evaluation& evaluation);

 private:
  static SensorRows Bound(const taskc_recording& recording, host::TaskFrame& frame,
                          SensorSources& sensors);
  void CopySettings(const Episode& like);
  void Show(taskc_int64 row) {
    rows_.Advance();
    of_time_steps_.Load(row);
  }
  void Start();
  bool StartsAction(taskc_int64 row) const;
  bool EndsAction(taskc_int64 row) const;
  bool IsPlain() const;
  taskc_int64 EndPlainTimeSteps(taskc_int64 row);
  void StartTimeStep(taskc_int64 row);
  void EndTimeStep(taskc_int64 row);
  void Tell(int event, double time_step) {
    if (task_.events[event] != nullptr) row_reward_ += episode_.Call(event, time_step).reward;
  }
  bool IsCutOff() const;
  bool GoesOnAfter(taskc_int64 row) const;
  void NoteRow(taskc_int64 row);
  void FillAfter(taskc_int64 row);
  void End(taskc_int64 row);
  void Report(taskc_evaluation& evaluation) const;

  const taskc_plugin& task_;
  const taskc_recording& recording_;
  Episode episode_;
  SensorSources sensors_;
  const SensorRows rows_;         // of the sensors that are read where they are
  SensorReadings of_time_steps_;  // the others, that are read in each time step
  SensorReadings of_ends_;   // those that are read only at the start and the end of the episode
  const taskc_int64 first_;  // the row of the first time step
  taskc_int64 next_action_;  // the row in which one starts, where `action_length` says it
  taskc_int64 time_steps_ = 0;
  double row_reward_ = 0;  // what the events of the present row have paid
};

}  // namespace libtaskc
