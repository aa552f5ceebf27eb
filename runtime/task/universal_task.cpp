#include "runtime/task/universal_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

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
  frame_.sensors = sensor_data_.data();
  frame_.params = param_values_.data();
  frame_.memory = memory_.data();
  frame_.terms = term_sums_.data();
  frame_.metrics = measured_.data();
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
  std::fill(faults_.begin(), faults_.end(), TermFaults());
  fault_count_ = 0;
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
  function(&frame_);
  CountFault();

  Outcome outcome;
  outcome.reward = frame_.reward;
  const bool ends = frame_.end >= 0 && static_cast<uint32_t>(frame_.end) < plugin().end_count;
  if (ends) outcome.end = &plugin().ends[frame_.end];
  return outcome;
}

void UniversalTask::CountFault() {
  if (frame_.fault >= 0 && static_cast<uint32_t>(frame_.fault) < faults_.size()) {
    TermFaults& faults = faults_[static_cast<size_t>(frame_.fault)];
    if (faults.count++ == 0) faults.first_time = time_;
    ++fault_count_;
  }
  if (!std::isfinite(frame_.reward)) {
    frame_.reward = 0;
    ++fault_count_;
  }
}

void UniversalTask::Emit(const std::optional<Outcome>& outcome) {
  if (!outcome) return;
  reward(outcome->reward);
  if (outcome->end == nullptr || end_was_emitted_ || episode_is_over_) return;
  end_was_emitted_ = true;
  end_of_episode({KindOf(*outcome->end), outcome->end->reason});
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
