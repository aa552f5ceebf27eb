#include "plugins/host/task_episode.h"

#include "plugins/host/log_value.h"

namespace host {

TaskEpisode::TaskEpisode(const taskc_plugin& plugin)
    : frame_(plugin), reducer_({plugin.metrics, plugin.metric_count}), logged_(plugin.log_count) {}

void TaskEpisode::Start() {
  frame_.Clear();
  reducer_.StartEpisode();
  time_step_ = 0;
}

void TaskEpisode::Measure() {
  frame_.frame().time_step = time_step_;  // of the last event it may be another
  frame_.Measure();
}

void TaskEpisode::MeasureTimeStep() {
  Measure();
  reducer_.EndTimeStep(frame_.metrics());
}

void TaskEpisode::End() {
  Measure();
  reducer_.EndEpisode(frame_.metrics());
  for (size_t i = 0; i < logged_.size(); ++i) {
    logged_[i] = LogValue(frame_.plugin().logs[i].reduction, frame_.logs()[i]);
  }
}

}  // namespace host
