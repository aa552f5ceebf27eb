#include "runtime/core/task/task_instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <string_view>

#include "runtime/core/task/saved_values.h"

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

taskc_int32 OutcomeOf(EndKind kind) {
  switch (kind) {
    case EndKind::kSuccess:
      return TASKC_SUCCESS;
    case EndKind::kFailure:
      return TASKC_FAILURE;
    case EndKind::kTruncated:
    case EndKind::kDiverged:
      break;
  }
  return TASKC_TRUNCATED;
}

void NoteIncident(Incidents& incidents, double time) {
  if (incidents.count++ == 0) incidents.first_time = time;
}

std::span<const taskc_param> ParamsOf(const taskc_plugin& table) {
  return {table.params, table.param_count};
}

// Whether what was added up for one of them goes on as the other.
bool IsSame(const taskc_reward_term& a, const taskc_reward_term& b) {
  return std::string_view(a.name) == b.name;
}
template <class Curve>
bool IsSame(const Curve& a, const Curve& b) {
  return std::string_view(a.name) == b.name && std::string_view(a.unit) == b.unit &&
         a.reduction == b.reduction;
}

// Calls `action(i, j)` for each i of `now` and j of `old` that are the same.
template <class Item, class Action>
void ForEachSame(std::span<const Item> now, std::span<const Item> old, Action action) {
  for (size_t i = 0; i < now.size(); ++i) {
    for (size_t j = 0; j < old.size(); ++j) {
      if (IsSame(now[i], old[j])) action(i, j);
    }
  }
}

}  // namespace

ObservationLayout ObservationLayoutOf(const taskc_plugin& table) {
  ObservationLayout layout;
  for (const taskc_observation& each : std::span(table.observations, table.observation_count)) {
    layout.values.push_back({.name = each.name,
                             .type = each.type,
                             .unit = each.unit,
                             .size = size_t{each.rows} * each.columns,
                             .minimum = each.minimum,
                             .maximum = each.maximum});
  }
  return layout;
}

TaskInstance::TaskInstance(std::shared_ptr<const Plugin> plugin, int64_t id)
    : plugin_(std::move(plugin)),
      id_(id),
      episode_(table()),
      host_(episode_.frame()),
      memory_(host_),
      goals_(host_),
      phases_(host_),
      told_(table()),
      params_(table().param_count),
      faults_(table().term_count),
      fault_state_(host_),
      violations_(table().requirement_count),
      observation_faults_(table().observation_count) {
  for (size_t i = 0; i < params_.size(); ++i) SetParam(i, table().params[i].initial);
  PassParams();
  for (const taskc_requirement& requirement :
       std::span(table().requirements, table().requirement_count)) {
    violation_reasons_.push_back(fmt::format("requirement: {}", requirement.reason));
  }
  if (table().initialize != nullptr) Enter(table().initialize);
  StartEpisode(0, 0);
}

std::vector<Parameter> TaskInstance::Params() {
  std::vector<Parameter> parameters;
  for (size_t i = 0; i < params_.size(); ++i) {
    const taskc_param& param = table().params[i];
    Parameter parameter{.name = param.name,
                        .doc = param.doc,
                        .target = &params_[i].real,
                        .minimum = param.minimum,
                        .maximum = param.maximum,
                        .unit = param.unit};
    if (param.scalar == TASKC_BOOL) parameter.target = &params_[i].flag;
    if (param.scalar == TASKC_INT) parameter.target = &params_[i].integer;
    parameters.push_back(std::move(parameter));
  }
  std::ranges::move(told_.Parameters(), std::back_inserter(parameters));
  return parameters;
}

// The plugin passes and gets every param as a double, whatever its type.
void TaskInstance::PassParams() {
  for (size_t i = 0; i < params_.size(); ++i) {
    const taskc_int32 scalar = table().params[i].scalar;
    host_.params()[i] = scalar == TASKC_BOOL  ? static_cast<double>(params_[i].flag)
                        : scalar == TASKC_INT ? static_cast<double>(params_[i].integer)
                                              : params_[i].real;
  }
}

void TaskInstance::SetParam(size_t index, double value) {
  params_[index] = {value != 0, static_cast<int64_t>(value), value};
}

void TaskInstance::StartEpisode(uint64_t run_seed, int64_t episode) {
  episode_.Start();
  std::fill(faults_.begin(), faults_.end(), Incidents());
  fault_count_ = 0;
  fault_state_.StartEpisode();
  std::fill(violations_.begin(), violations_.end(), Incidents());
  std::fill(observation_faults_.begin(), observation_faults_.end(), Incidents());
  goals_.StartEpisode(run_seed, episode);
  phases_.StartEpisode();
  time_ = 0;
}

void TaskInstance::SetOutcome(EndKind kind) { host_.SetOutcome(OutcomeOf(kind)); }

std::optional<robot::StartState> TaskInstance::DrawStart(const robot::RobotDescription& robot,
                                                         uint64_t run_seed, int64_t episode,
                                                         uint32_t attempt) {
  const InsideOfTask watched(id_);
  goals_.StartEpisode(run_seed, episode);
  return runtime::DrawStart(host_, robot, attempt);
}

void TaskInstance::Enter(taskc_event_function function) {
  const InsideOfTask watched(id_);
  function(&host_.frame());
}

std::optional<TaskInstance::Outcome> TaskInstance::Call(int event, double time_step) {
  if (table().events[event] == nullptr) return std::nullopt;
  const size_t phase = phases_.present();
  fault_state_.NoteMemory();
  const host::EventOutcome outcome = Enter(event, time_step);
  goals_.NoteDraws(time_);
  Count(event, time_step, outcome);
  phases_.AddReward(phase, outcome.reward);
  return Outcome{outcome.reward, EndReached(outcome)};
}

host::EventOutcome TaskInstance::Enter(int event, double time_step) {
  const InsideOfTask watched(id_);
  return episode_.Call(event, time_step).value();
}

std::optional<EpisodeEnd> TaskInstance::EndReached(const host::EventOutcome& outcome) const {
  if (outcome.violation >= 0) {
    const auto requirement = static_cast<size_t>(outcome.violation);
    return EpisodeEnd{EndKind::kTruncated, violation_reasons_[requirement].c_str()};
  }
  if (outcome.end < 0) return std::nullopt;
  const taskc_end& end = table().ends[outcome.end];
  return EpisodeEnd{KindOf(end), end.reason};
}

void TaskInstance::Count(int event, double time_step, const host::EventOutcome& outcome) {
  if (outcome.fault >= 0) {
    const auto term = static_cast<size_t>(outcome.fault);
    NoteIncident(faults_[term], time_);
    ++fault_count_;
    fault_state_.Keep(event, term, time_step);
  }
  if (!outcome.is_paid) ++fault_count_;
  if (outcome.violation >= 0) {
    NoteIncident(violations_[static_cast<size_t>(outcome.violation)], time_);
  }
}

void TaskInstance::EndTimeStep() {
  const InsideOfTask watched(id_);
  episode_.MeasureTimeStep();
}

void TaskInstance::Measure() {
  const InsideOfTask watched(id_);
  episode_.Measure();
}

void TaskInstance::EndEpisode() {
  const InsideOfTask watched(id_);
  episode_.End();
}

std::span<const double> TaskInstance::Observe() {
  if (table().observe == nullptr) return {};
  Enter(table().observe);
  for (size_t i = 0; i < observation_faults_.size(); ++i) {
    const taskc_observation& each = table().observations[i];
    for (double& number : host_.observations().subspan(each.offset, each.rows * each.columns)) {
      if (std::isfinite(number)) continue;
      number = 0;
      NoteIncident(observation_faults_[i], time_);
    }
  }
  return host_.observations();
}

void TaskInstance::TakeOver(const TaskInstance& old, bool in_episode) {
  TakeOverParams(old);
  told_.TakeOver(old.told_);
  memory_.TakeOver(old.memory_, in_episode);
  if (in_episode) TakeOverSums(old);
}

void TaskInstance::TakeOverParams(const TaskInstance& old) {
  for (size_t i = 0; i < params_.size(); ++i) {
    const taskc_param& param = table().params[i];
    for (size_t j = 0; j < old.params_.size(); ++j) {
      const taskc_param& before = old.table().params[j];
      const double value = old.host_.params()[j];
      const bool is_same = std::string_view(param.name) == before.name &&
                           std::string_view(param.unit) == before.unit &&
                           param.scalar == before.scalar;
      const bool is_in_range = param.minimum <= value && value <= param.maximum;
      if (is_same && value != before.initial && is_in_range) SetParam(i, value);
    }
  }
  PassParams();
}

void TaskInstance::TakeOverSums(const TaskInstance& old) {
  ForEachSame(std::span(table().terms, table().term_count),
              std::span(old.table().terms, old.table().term_count), [&](size_t i, size_t j) {
                host_.terms()[i] = old.host_.terms()[j];
                faults_[i] = old.faults_[j];
              });
  ForEachSame(std::span(table().logs, table().log_count),
              std::span(old.table().logs, old.table().log_count),
              [&](size_t i, size_t j) { host_.logs()[i] = old.host_.logs()[j]; });
  ForEachSame(std::span(table().metrics, table().metric_count),
              std::span(old.table().metrics, old.table().metric_count),
              [&](size_t i, size_t j) { episode_.TakeOverMetric(i, old.episode_, j); });
  goals_.TakeOver(old.goals_);
  phases_.TakeOver(old.phases_);
  fault_count_ = old.fault_count_;
  time_ = old.time_;
  episode_.TakeOverTimeStep(old.episode_);
}

void TaskInstance::Save(std::ostream& stream) const {
  const auto told = told_.Saved();
  SaveNumber(stream, table().param_count + static_cast<uint32_t>(told.size()));
  for (uint32_t i = 0; i < table().param_count; ++i) {
    SaveText(stream, table().params[i].name);
    SaveNumber(stream, host_.params()[i]);
  }
  for (const auto& [name, number] : told) {
    SaveText(stream, name);
    SaveNumber(stream, number);
  }
  memory_.Save(stream);
}

void TaskInstance::Load(std::istream& stream) {
  const auto count = LoadNumber<uint32_t>(stream);
  for (uint32_t saved = 0; saved < count; ++saved) {
    const std::string name = LoadText(stream);
    const auto value = LoadNumber<double>(stream);
    told_.Restore(name, value);
    const auto params = ParamsOf(table());
    for (size_t i = 0; i < params.size(); ++i) {
      const bool fits = params[i].minimum <= value && value <= params[i].maximum;
      if (params[i].name == name && fits) SetParam(i, value);
    }
  }
  PassParams();
  memory_.Load(stream);
}

}  // namespace runtime
