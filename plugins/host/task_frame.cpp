#include "plugins/host/task_frame.h"

#include <algorithm>
#include <cstring>

namespace host {

TaskFrame::TaskFrame(const taskc_plugin& plugin)
    : plugin_(plugin),
      sensors_(plugin.sensor_count),
      memory_(plugin.memory_size),
      terms_(plugin.term_count),
      metrics_(plugin.metric_count),
      observations_(plugin.observation_size),
      logs_(plugin.log_count) {
  for (const taskc_param& param : std::span(plugin.params, plugin.param_count)) {
    params_.push_back(param.initial);
  }
  frame_.sensors = sensors_.data();
  frame_.params = params_.data();
  frame_.memory = memory_.data();
  frame_.discount = 1;
  frame_.outcome = TASKC_TRUNCATED;
  frame_.terms = terms_.data();
  frame_.metrics = metrics_.data();
  frame_.observations = observations_.data();
  frame_.logs = logs_.data();
}

taskc_int64 TaskFrame::DrawCount(const taskc_goal& goal) const {
  taskc_int64 count = 0;
  std::memcpy(&count, memory_.data() + goal.draw_offset, sizeof count);
  return count;
}

taskc_int64 TaskFrame::PresentPhase() const {
  taskc_int64 phase = 0;
  std::memcpy(&phase, memory_.data() + plugin_.phase_offset, sizeof phase);
  return phase;
}

void TaskFrame::SetPhase(taskc_int64 phase) {
  std::memcpy(memory_.data() + plugin_.phase_offset, &phase, sizeof phase);
}

void TaskFrame::SetPhaseTime(double time) {
  std::memcpy(memory_.data() + plugin_.phase_time_offset, &time, sizeof time);
}

void TaskFrame::Clear() {
  std::ranges::fill(terms_, 0.0);
  std::ranges::fill(logs_, taskc_log_state());
}

}  // namespace host
