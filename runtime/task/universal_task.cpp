#include "runtime/task/universal_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "runtime/task/log_value.h"
#include "runtime/task/robot_check.h"
#include "runtime/task/saved_values.h"

namespace runtime {
namespace {

EndKind KindOf(const taskc_end& end) {
  switch (end.kind) {
    case TASKC_SUCCESS:
      return EndKind::kSuccess;
    case TASKC_FAILURE:
      return EndKind::kFailure;
    default:
      assert(end.kind == TASKC_TRUNCATED);
      return EndKind::kTruncated;
  }
}

bool IsIndex(taskc_int32 index, uint32_t count) {
  return index >= 0 && static_cast<uint32_t>(index) < count;
}

void Count(Incidents& incidents, double time) {
  if (incidents.count++ == 0) incidents.first_time = time;
}

// The plugin passes every param as a double, whatever its type.
ParameterValue TypedValue(const taskc_param& param, double value) {
  if (param.scalar == TASKC_BOOL) return value != 0;
  if (param.scalar == TASKC_INT) return static_cast<int64_t>(value);
  return value;
}

}  // namespace

UniversalTask::UniversalTask(std::string name, const Context& context)
    : Module(std::move(name)),
      plugin_(context.task_plugin),
      memory_(plugin_.table()),
      reducer_({plugin_.table().metrics, plugin_.table().metric_count}) {
  CheckFitsRobot(plugin_, *context.robot);
  AddParams();
  AddSensors();
  BindFrame();
  if (plugin().initialize != nullptr) plugin().initialize(&frame_);
  ResetEpisode();
}

void UniversalTask::AddParams() {
  params_.resize(plugin().param_count);
  param_values_.resize(plugin().param_count);
  for (uint32_t i = 0; i < plugin().param_count; ++i) {
    const taskc_param& param = plugin().params[i];
    Parameter parameter{param.name, param.doc, &params_[i].real, {}, param.minimum, param.maximum};
    if (param.scalar == TASKC_BOOL) parameter.target = &params_[i].flag;
    if (param.scalar == TASKC_INT) parameter.target = &params_[i].integer;
    AddParameter(std::move(parameter));
    Set(param.name, TypedValue(param, param.initial));
  }
}

void UniversalTask::Set(std::string_view parameter, const ParameterValue& value) {
  Module::Set(parameter, value);
  for (uint32_t i = 0; i < plugin().param_count; ++i) {
    const taskc_param& param = plugin().params[i];
    const Param& typed = params_[i];
    if (param.name != parameter) continue;
    param_values_[i] = param.scalar == TASKC_BOOL  ? static_cast<double>(typed.flag)
                       : param.scalar == TASKC_INT ? static_cast<double>(typed.integer)
                                                   : typed.real;
  }
}

void UniversalTask::AddSensors() {
  sensor_data_.resize(plugin().sensor_count);
  for (uint32_t i = 0; i < plugin().sensor_count; ++i) {
    const taskc_sensor& sensor = plugin().sensors[i];
    sensors_.push_back(
        std::make_unique<SensorIn>(this, sensor.name, SensorTypeText(sensor.type, sensor.unit)));
    for (size_t reader = 0; reader < reads_.size(); ++reader) {
      if ((sensor.read_by >> reader & 1) == 0) continue;
      reads_[reader].push_back({sensors_.back().get(), &sensor_data_[i]});
    }
  }
}

void UniversalTask::BindFrame() {
  term_sums_.resize(plugin().term_count);
  faults_.resize(plugin().term_count);
  measured_.resize(plugin().metric_count);
  log_states_.resize(plugin().log_count);
  logged_.resize(plugin().log_count);
  violations_.resize(plugin().requirement_count);
  for (const taskc_requirement& requirement :
       std::span(plugin().requirements, plugin().requirement_count)) {
    violation_reasons_.push_back(fmt::format("requirement: {}", requirement.reason));
  }
  frame_.sensors = sensor_data_.data();
  frame_.params = param_values_.data();
  frame_.memory = memory_.data();
  frame_.terms = term_sums_.data();
  frame_.metrics = measured_.data();
  frame_.logs = log_states_.data();
}

void UniversalTask::Start() {
  for (const auto& sensor : sensors_) {
    if (sensor->connected()) continue;
    throw UserError(
        fmt::format("`{}` has no connection: connect it to an out port of the type `{}`",
                    sensor->full_name(), sensor->type().text));
  }
}

void UniversalTask::ResetEpisode() {
  std::fill(term_sums_.begin(), term_sums_.end(), 0.0);
  std::fill(faults_.begin(), faults_.end(), Incidents());
  fault_count_ = 0;
  std::fill(violations_.begin(), violations_.end(), Incidents());
  std::fill(log_states_.begin(), log_states_.end(), taskc_log_state());
  reducer_.StartEpisode();
  time_ = 0;
  episode_is_over_ = false;
  end_was_emitted_ = false;
}

void UniversalTask::StartEpisode() {
  ResetEpisode();
  Handle(TASKC_START_OF_EPISODE, 0);
}

void UniversalTask::EndTimeStep(double time_step) {
  time_ += time_step;
  const std::optional<Outcome> outcome = Call(TASKC_END_OF_TIME_STEP, time_step);
  // Before anyone hears of the outcome: it may end the episode, and this step belongs to it.
  if (reducer_.needs_time_steps() && !episode_is_over_) {
    Measure();
    reducer_.EndTimeStep(measured_);
  }
  Emit(outcome);
}

// A task is not told why the episode is over: the learner or the environment may have ended it.
void UniversalTask::EndEpisode(EpisodeEnd) {
  if (episode_is_over_) return;
  episode_is_over_ = true;
  const std::optional<Outcome> outcome = Call(TASKC_END_OF_EPISODE, 0);
  Measure();
  reducer_.EndEpisode(measured_);
  ReduceLogs();
  Emit(outcome);
}

void UniversalTask::Handle(int event, double time_step) { Emit(Call(event, time_step)); }

std::optional<UniversalTask::Outcome> UniversalTask::Call(int event, double time_step) {
  const taskc_event_function function = plugin().events[event];
  if (function == nullptr) return std::nullopt;
  Sense(event);
  frame_.time_step = time_step;
  frame_.reward = 0;
  frame_.end = -1;
  frame_.fault = -1;
  frame_.violation = -1;
  function(&frame_);
  CountFault();
  CountViolation();
  return Outcome{frame_.reward, EndReached()};
}

std::optional<EpisodeEnd> UniversalTask::EndReached() const {
  if (IsIndex(frame_.violation, plugin().requirement_count)) {
    const auto requirement = static_cast<size_t>(frame_.violation);
    return EpisodeEnd{EndKind::kTruncated, violation_reasons_[requirement].c_str()};
  }
  if (!IsIndex(frame_.end, plugin().end_count)) return std::nullopt;
  const taskc_end& end = plugin().ends[frame_.end];
  return EpisodeEnd{KindOf(end), end.reason};
}

void UniversalTask::CountFault() {
  if (IsIndex(frame_.fault, plugin().term_count)) {
    Count(faults_[static_cast<size_t>(frame_.fault)], time_);
    ++fault_count_;
  }
  if (!std::isfinite(frame_.reward)) {
    frame_.reward = 0;
    ++fault_count_;
  }
}

void UniversalTask::CountViolation() {
  if (!IsIndex(frame_.violation, plugin().requirement_count)) return;
  Count(violations_[static_cast<size_t>(frame_.violation)], time_);
}

void UniversalTask::ReduceLogs() {
  for (uint32_t i = 0; i < plugin().log_count; ++i) {
    logged_[i] = LogValue(plugin().logs[i].reduction, log_states_[i]);
  }
}

void UniversalTask::Emit(const std::optional<Outcome>& outcome) {
  if (!outcome) return;
  reward(outcome->reward);
  if (!outcome->end || end_was_emitted_ || episode_is_over_) return;
  end_was_emitted_ = true;
  end_of_episode(*outcome->end);
}

void UniversalTask::Sense(int reader) {
  for (const SensorRead& read : reads_[static_cast<size_t>(reader)]) {
    *read.data = (*read.port)().data;
  }
}

void UniversalTask::Measure() {
  if (plugin().measure == nullptr) return;
  Sense(TASKC_MEASURE);
  plugin().measure(&frame_);
}

void UniversalTask::Save(std::ostream& stream) const {
  SaveNumber(stream, plugin().param_count);
  for (uint32_t i = 0; i < plugin().param_count; ++i) {
    SaveText(stream, plugin().params[i].name);
    SaveNumber(stream, param_values_[i]);
  }
  memory_.Save(stream);
}

void UniversalTask::Load(std::istream& stream) {
  const auto count = LoadNumber<uint32_t>(stream);
  for (uint32_t i = 0; i < count; ++i) {
    const std::string name = LoadText(stream);
    const auto value = LoadNumber<double>(stream);
    for (const taskc_param& param : std::span(plugin().params, plugin().param_count)) {
      if (param.name == name) Set(name, TypedValue(param, value));
    }
  }
  memory_.Load(stream);
}

}  // namespace runtime
