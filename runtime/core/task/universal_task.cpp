#include "runtime/core/task/universal_task.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "plugins/robot/sensors.h"
#include "runtime/base/suggestion.h"
#include "runtime/core/module/connections.h"
#include "runtime/core/task/robot_check.h"
#include "runtime/core/task/saved_values.h"

namespace runtime {
namespace {

PortType TypeOf(const taskc_sensor& sensor) {
  return MakeValueType<SensorData>(SensorTypeText(sensor.type, sensor.unit));
}

std::span<const taskc_sensor> SensorsOf(const taskc_plugin& table) {
  return {table.sensors, table.sensor_count};
}

bool IsOfRobots(const taskc_sensor& sensor) { return robot::FindSensor(sensor.name) != nullptr; }

// A module is called like its sensor, but names of modules have no dots.
std::string ModuleNameFor(std::string sensor) {
  std::ranges::replace(sensor, '.', '_');
  return sensor;
}

// How an agent, or a run, gets a module that offers the sensor.
std::string Remedy(const taskc_sensor& sensor) {
  if (IsOfRobots(sensor)) return "";
  const std::string_view type = sensor.type;
  const bool is_small = type == "real" || type.starts_with("vec");
  if (!is_small || type.find('[') != std::string_view::npos)
    return "; add a module that has one to the agent";
  return fmt::format(
      "\n  help: add one to the agent file:\n    [modules.{0}]\n    type = \"SignalGenerator\"\n"
      "    sensor = \"{1}\"\n    shape = \"{2}\"\n    unit = \"{3}\"\n"
      "  or, while a run goes on: trainer ctl module add SignalGenerator {0} sensor={1} shape={2} "
      "'unit={3}'",
      ModuleNameFor(sensor.name), sensor.name, type, sensor.unit);
}

// How a run can begin without such a module.
std::string ToldByOption(std::string_view module, const taskc_sensor& sensor) {
  const size_t size = size_t{sensor.rows} * sensor.columns;
  const std::string zeros = fmt::format("{}", fmt::join(std::vector(size, 0), ", "));
  return Remedy(sensor) + fmt::format("\n  or tell it a value: --set '{}.{}={}'", module,
                                      sensor.name, size == 1 ? zeros : "[" + zeros + "]");
}

[[noreturn]] void ThrowNotOffered(const taskc_plugin& table, const taskc_sensor& sensor,
                                  const std::string& hint) {
  throw UserError(fmt::format(
      "the task `{}` reads the sensor `{}`, and no module has an out port `{}` of the type `{}`{}",
      table.name, sensor.name, sensor.name, TypeOf(sensor).text,
      hint.empty() ? Remedy(sensor) : hint));
}

// One of the same name and another type, or one of nearly the same name; "" where there is none.
std::string NearOffer(const ModuleGraph& graph, const taskc_sensor& sensor) {
  std::vector<std::string> names;
  for (const auto& module : graph.modules()) {
    for (const Port* port : module->ports()) {
      if (port->kind() != PortKind::kOut || port->type().cpp != typeid(SensorData)) continue;
      if (port->name() == sensor.name)
        return fmt::format("; `{}` is of the type `{}`", port->full_name(), port->type().text);
      // The compiler knows what robots offer: such a name is no misspelled one.
      if (robot::FindSensor(port->name()) == nullptr) names.push_back(port->name());
    }
  }
  if (IsOfRobots(sensor) || names.empty()) return "";
  std::string suggestion = Suggestion(sensor.name, names);
  const bool is_near = suggestion.starts_with(':');  // else it lists all
  return is_near ? suggestion : "";
}

void CheckIsOffered(const ModuleGraph& graph, const taskc_sensor& sensor,
                    const taskc_plugin& table) {
  if (FindOut(graph, sensor.name, TypeOf(sensor)) == nullptr)
    ThrowNotOffered(table, sensor, NearOffer(graph, sensor));
}

std::unique_ptr<TaskInstance> FirstInstance(const std::string& name, const Context& context) {
  if (context.task == nullptr) {
    throw UserError(fmt::format("the module `{}` has no initial task", name));
  }
  return std::make_unique<TaskInstance>(context.task);
}

}  // namespace

UniversalTask::UniversalTask(const std::string& name, const Context& context)
    : UniversalTask(name, *context.robot, FirstInstance(name, context), context.seed) {}

UniversalTask::UniversalTask(std::string name, const robot::RobotDescription& robot,
                             std::unique_ptr<TaskInstance> instance, uint64_t seed)
    : Module(std::move(name)), robot_(robot), seed_(seed) {
  CheckFitsRobot(*instance->plugin(), robot_);
  Exchange(std::move(instance));
}

void UniversalTask::Set(std::string_view parameter, const ParameterValue& value) {
  const std::optional<size_t> sensor = told().Find(parameter);
  if (!sensor) {
    Module::Set(parameter, value);
    return instance_->PassParams();
  }
  // What is written where nothing is told, as a run's record has it.
  const auto* list = std::get_if<std::vector<double>>(&value);
  if (list != nullptr && list->empty() && !told().IsTold(*sensor)) return;
  Module::Set(parameter,
              told().ElementsIn(*sensor, value, fmt::format("{}.{}", name(), parameter)));
  told().Pass(*sensor);
  DisconnectTold();
}

void UniversalTask::Start() {
  DisconnectTold();
  for (size_t i = 0; i < sensors_.size(); ++i) {
    const taskc_sensor& sensor = plugin().sensors[i];
    if (sensors_[i]->connected() || told().IsTold(i)) continue;
    if (!IsOfRobots(sensor)) ThrowNotOffered(plugin(), sensor, ToldByOption(name(), sensor));
    RequireConnection(*sensors_[i]);
  }
}

void UniversalTask::DisconnectTold() {
  for (size_t i = 0; i < sensors_.size(); ++i) {
    if (told().IsTold(i)) sensors_[i]->Disconnect();
  }
  BindSensors();
}

void UniversalTask::NoteConnection() {
  for (size_t i = 0; i < sensors_.size(); ++i) {
    if (sensors_[i]->connected()) told().Forget(i);
  }
  BindSensors();
}

UniversalTask::Sensors::const_iterator UniversalTask::FindSensor(const taskc_sensor& sensor) const {
  const PortType type = TypeOf(sensor);
  return std::ranges::find_if(sensors_, [&](const auto& port) {
    return port != nullptr && port->name() == sensor.name && port->type() == type;
  });
}

std::unique_ptr<TaskInstance> UniversalTask::Exchange(std::unique_ptr<TaskInstance> next) {
  std::vector<std::unique_ptr<SensorIn>> kept;
  for (const taskc_sensor& sensor : SensorsOf(next->table())) {
    const auto same = FindSensor(sensor);
    kept.push_back(same == sensors_.end() ? nullptr : std::move(sensors_[same - sensors_.begin()]));
  }
  sensors_.clear();  // before the new ones are made: they may have the same names
  for (size_t i = 0; i < kept.size(); ++i) {
    const taskc_sensor& sensor = next->table().sensors[i];
    if (kept[i] != nullptr) continue;
    kept[i] =
        std::make_unique<SensorIn>(this, sensor.name, SensorTypeText(sensor.type, sensor.unit));
  }
  sensors_ = std::move(kept);
  std::swap(instance_, next);
  ReplaceParameters(instance_->Params());
  BindSensors();
  return next;
}

void UniversalTask::BindSensors() {
  for (size_t i = 0; i < sensors_.size(); ++i) {
    if (told().IsTold(i)) *instance_->sensor_data(i) = told().Data(i);
  }
  for (size_t reader = 0; reader < reads_.size(); ++reader) {
    reads_[reader].clear();
    for (size_t i = 0; i < sensors_.size(); ++i) {
      if ((plugin().sensors[i].read_by >> reader & 1) == 0 || told().IsTold(i)) continue;
      reads_[reader].push_back({sensors_[i].get(), instance_->sensor_data(i)});
    }
  }
}

void UniversalTask::CheckCanLoad(const Plugin& plugin, const UniversalTask& active,
                                 const ModuleGraph& graph) {
  CheckFitsRobot(plugin, active.robot_);
  for (const taskc_sensor& sensor : SensorsOf(plugin.table())) {
    if (active.told().IsToldFor(sensor)) continue;
    CheckIsOffered(graph, sensor, plugin.table());
  }
}

void UniversalTask::CheckCanSwap(const Plugin& plugin, const ModuleGraph& graph) const {
  CheckFitsRobot(plugin, robot_);
  const taskc_plugin& table = plugin.table();
  for (const taskc_sensor& sensor : SensorsOf(table)) {
    const auto present = FindSensor(sensor);
    if (present != sensors_.end() && (*present)->connected()) continue;
    if (told().IsToldFor(sensor)) continue;
    CheckIsOffered(graph, sensor, table);
  }
}

void UniversalTask::ConnectSensors(const ModuleGraph& graph) {
  runtime::ConnectSensors(*this, graph);
  DisconnectTold();
}

void UniversalTask::Swap(std::unique_ptr<TaskInstance> next, const ModuleGraph& graph) {
  CheckCanSwap(*next->plugin(), graph);
  const bool in_episode = !episode_is_over_ && !is_asleep_;
  next->TakeOver(*instance_, in_episode);
  previous_ = Exchange(std::move(next));
  ConnectSensors(graph);
}

// Not the previous instance itself: what it remembers of an episode is of one that is long over.
const TaskInstance& UniversalTask::FindPrevious() const {
  if (previous_ != nullptr) return *previous_;
  throw UserError(fmt::format("`{}` has no previous task: it has not been swapped yet", name()));
}

void UniversalTask::Rollback(const ModuleGraph& graph) {
  const TaskInstance& previous = FindPrevious();
  auto next = std::make_unique<TaskInstance>(previous.plugin(), previous.id());
  next->TakeOver(previous, false);
  Swap(std::move(next), graph);
}

size_t UniversalTask::FindGoal(std::string_view goal) const {
  if (const auto found = instance_->goals().Find(goal)) return *found;
  std::vector<std::string> names;
  for (const taskc_goal& each : instance_->goals().goals()) names.emplace_back(each.name);
  throw UserError(
      fmt::format("the task `{}` has no goal `{}`{}", plugin().name, goal,
                  names.empty() ? "" : fmt::format("; its goals are {}", fmt::join(names, ", "))));
}

void UniversalTask::HoldGoal(size_t goal, std::span<const double> value) {
  const size_t wanted = instance_->goals().Value(goal).size();
  if (value.size() != wanted) {
    throw UserError(fmt::format("the goal `{}` has {} element{}, not {}",
                                instance_->goals().goals()[goal].name, wanted,
                                wanted == 1 ? "" : "s", value.size()));
  }
  instance_->HoldGoal(goal, value);
}

void UniversalTask::StartEpisode() {
  instance_->StartEpisode(seed_, ++episode_);
  end_.reason.clear();
  is_asleep_ = false;
  episode_is_over_ = false;
  end_was_reached_ = false;
  Handle(TASKC_START_OF_EPISODE, 0);
  return_ = 0;  // a learner does not count what is paid before its first action either
}

void UniversalTask::EndAction() {
  instance_->SetDiscount(*discount_);
  Handle(TASKC_END_OF_ACTION, 0);
  if (role_ == Role::kShadowEndsWithAction) EndOwnEpisode();
}

void UniversalTask::EndTimeStep(double time_step) {
  if (is_asleep_) return;
  instance_->AdvanceTime(time_step);
  const std::optional<Outcome> outcome = Call(TASKC_END_OF_TIME_STEP, time_step);
  // Before anyone hears of the outcome: it may end the episode, and this step belongs to it.
  if (instance_->needs_measuring() && !episode_is_over_) {
    Sense(TASKC_MEASURE);
    instance_->EndTimeStep();
  }
  Emit(outcome);
}

// The learner or the environment may have ended it, and for another reason than the task has.
void UniversalTask::EndEpisode(EpisodeEnd end) {
  if (episode_is_over_ || is_asleep_) return;
  episode_is_over_ = true;
  instance_->SetDiscount(*discount_);
  instance_->SetOutcome(end.kind);
  if (!end_was_reached_) NoteEnd(end);
  const std::optional<Outcome> outcome = Call(TASKC_END_OF_EPISODE, 0);
  Sense(TASKC_MEASURE);
  instance_->EndEpisode();
  Emit(outcome);
}

void UniversalTask::NoteEnd(const EpisodeEnd& end) {
  end_.kind = end.kind;
  end_.reason = end.reason;
}

void UniversalTask::EndOwnEpisode() {
  if (!end_was_reached_ || is_asleep_) return;
  EndEpisode({end_.kind, end_.reason.c_str()});
  is_asleep_ = true;
}

void UniversalTask::Handle(int event, double time_step) {
  if (!is_asleep_) Emit(Call(event, time_step));
}

std::optional<UniversalTask::Outcome> UniversalTask::Call(int event, double time_step) {
  if (plugin().events[event] == nullptr) return std::nullopt;
  Sense(event);
  return instance_->Call(event, time_step);
}

void UniversalTask::Emit(const std::optional<Outcome>& outcome) {
  if (!outcome) return;
  return_ += outcome->reward;
  reward(outcome->reward);
  if (!outcome->end || end_was_reached_ || episode_is_over_) return;
  end_was_reached_ = true;
  NoteEnd(*outcome->end);
  end_of_episode(*outcome->end);
  if (role_ == Role::kShadowEndsAtOnce) EndOwnEpisode();
}

std::span<const double> UniversalTask::Observe() const {
  Sense(TASKC_OBSERVE);
  return instance_->Observe();
}

std::span<const double> UniversalTask::MeasureNow() {
  if (!instance_->needs_measuring() && !episode_is_over_) {
    Sense(TASKC_MEASURE);
    instance_->Measure();
  }
  return instance_->measured();
}

void UniversalTask::Sense(int reader) const {
  for (const SensorRead& read : reads_[static_cast<size_t>(reader)]) {
    *read.data = (*read.port)().data;
  }
}

void UniversalTask::Save(std::ostream& stream) const {
  instance_->Save(stream);
  SaveNumber(stream, static_cast<uint32_t>(previous_ == nullptr ? 0 : 1));
  if (previous_ != nullptr) previous_->Save(stream);
}

void UniversalTask::Load(std::istream& stream) {
  instance_->Load(stream);
  DisconnectTold();
  if (LoadNumber<uint32_t>(stream) != 0 && previous_ != nullptr) previous_->Load(stream);
}

}  // namespace runtime
