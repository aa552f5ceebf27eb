// How requests are answered that change what the run is made of: each is checked, written down and
// done, in this order.
#include <fmt/format.h>

#include <cmath>

#include "runtime/core/module/live_parameter.h"
#include "runtime/live/control/live_run.h"
#include "runtime/live/control/parameter_json.h"
#include "runtime/live/control/replies.h"
#include "runtime/live/control/versions.h"
#include "runtime/training/run/change_text.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/task_record.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

constexpr const char* kOfSchedule[] = {"from", "to", "episodes"};

std::string Text(const Json& arguments, const char* name) {
  return arguments.at(name).get<std::string>();
}

bool Flag(const Json& arguments, const char* name) { return arguments.value(name, false); }

TaskRecord Describe(const LoadedTask& loaded, const std::string& module) {
  TaskRecord task = DescribeTask(loaded.plugin->table(), module);
  task.plugin = loaded.kept;
  return task;
}

// Null where the record has another file of the same version: what it has is what must run.
std::shared_ptr<const Plugin> PluginFor(const TaskRecord& recorded, const LoadedTask& loaded) {
  return recorded.plugin == loaded.kept ? loaded.plugin : nullptr;
}

void AddMessages(const LoadedTask& loaded, Json& reply) {
  if (!loaded.messages.empty()) reply["messages"] = loaded.messages;
}

void CheckSchedule(const ScheduleParameter& schedule, const Parameter& parameter) {
  const std::string& name = schedule.parameter;
  if (!std::holds_alternative<double*>(parameter.target) &&
      !std::holds_alternative<int64_t*>(parameter.target) &&
      !std::holds_alternative<int*>(parameter.target)) {
    throw UserError(fmt::format("`{}` is not a number, so it has no schedule", name));
  }
  if (!parameter.is_live) {
    throw UserError(fmt::format("`{}` has no effect after the start of a run", name));
  }
  constexpr double kExact = 9007199254740992;  // up to here every whole number is a double
  for (const WrittenNumber& number : {schedule.from, schedule.to}) {
    parameter.CheckRange(name, AsReal(number));
    const bool is_exact = std::abs(AsReal(number)) <= kExact;
    if (is_exact || std::holds_alternative<double*>(parameter.target)) continue;
    throw UserError(fmt::format("a schedule of `{}` has no number as large as {}", name,
                                ToJson(number).dump()));
  }
  constexpr int64_t kMost = 1'000'000'000;
  if (schedule.episodes >= 1 && schedule.episodes <= kMost) return;
  throw UserError(
      fmt::format("`episodes` must lie in 1 .. {}, and {} does not", kMost, schedule.episodes));
}

ScheduleParameter ReadSchedule(const Json& arguments, const std::string& name) {
  for (const char* key : kOfSchedule) {
    if (arguments.contains(key)) continue;
    throw UserError(fmt::format(
        "`set {}` needs a `value`, or `from`, `to` and `episodes` for a schedule", name));
  }
  return {.parameter = name,
          .from = NumberFromJson(arguments.at("from")).value(),
          .to = NumberFromJson(arguments.at("to")).value(),
          .episodes = arguments.at("episodes").get<int64_t>()};
}

SetParameter ReadValue(const Json& arguments, const Parameter& parameter, const std::string& name) {
  for (const char* key : kOfSchedule) {
    if (!arguments.contains(key)) continue;
    throw UserError(
        fmt::format("`set {}`: a `value` has no `{}`, which is of a schedule", name, key));
  }
  return {.parameter = name,
          .value = FitTo(parameter, ValueFromJson(arguments.at("value"), name), name)};
}

}  // namespace

std::string LiveRun::Make(const Change& change, bool now, std::shared_ptr<const Plugin> plugin) {
  if (!now && position_.step != 0) {
    const RunPosition next_start = {position_.episode + 1, 0};
    journal_.AddDue(next_start, change, TextOf(change, run_.record), std::move(plugin));
    return fmt::format("episode {}", next_start.episode);
  }
  const ChangeRecord record = journal_.AddDone(position_, change, TextOf(change, run_.record));
  try {
    maker_.Do(change, {.episode = position_.next_whole_episode(), .plugin = std::move(plugin)});
  } catch (...) {
    journal_.Remove(record);
    throw;
  }
  NoteDone(record);
  return "now";
}

Json LiveRun::MakeNow(const Change& change) { return {{"takes_effect", Make(change, true)}}; }

void LiveRun::CheckIsGood(const TaskRecord& task) const {
  for (const TaskRecord& known : run_.record.tasks) {
    if (!IsSameVersion(known, task) || !journal_.bad_tasks().contains(known.id)) continue;
    throw UserError(
        fmt::format("`{}` has crashed in this run before: change it first", known.task));
  }
}

const TaskRecord& LiveRun::RecordTask(TaskRecord task) {
  for (const TaskRecord& known : run_.record.tasks) {
    if (known.module == task.module && IsSameVersion(known, task)) return known;
  }
  task.id = run_.database.AddTask(task);
  return run_.record.tasks.emplace_back(std::move(task));
}

Json LiveRun::Load(const QueuedRequest& request) {
  const Plugin& plugin = *request.task.plugin;
  const std::string name = request.arguments.value("name", std::string(plugin.table().name));
  TaskRecord task = Describe(request.task, name);
  CheckIsGood(task);
  graph_.CheckLoad(name, plugin);
  const TaskRecord& recorded = RecordTask(std::move(task));
  Json reply = TaskJson(name, recorded);
  Make(LoadShadow{.module = name, .task = recorded.id}, true, PluginFor(recorded, request.task));
  // It sleeps until then.
  reply["takes_effect"] = fmt::format("episode {}", position_.next_whole_episode());
  AddMessages(request.task, reply);
  return reply;
}

Json LiveRun::Swap(const QueuedRequest& request) {
  const std::string name = Text(request.arguments, "name");
  const bool forget = Flag(request.arguments, "forget");
  TaskRecord task = Describe(request.task, name);
  CheckIsGood(task);
  graph_.CheckSwap(name, *request.task.plugin);
  const TaskRecord& recorded = RecordTask(std::move(task));
  const SwapTask swap{.module = name, .task = recorded.id, .forget = forget};
  Json reply =
      Exchange(swap, PluginFor(recorded, request.task), forget, Flag(request.arguments, "now"));
  AddMessages(request.task, reply);
  return reply;
}

int64_t LiveRun::TaskToCome(const std::string& module, bool now) const {
  int64_t task = graph_.FindTask(module).instance().id();
  if (now || position_.step == 0) return task;
  const RunPosition next_start = {position_.episode + 1, 0};
  for (const DueChange& due : journal_.due()) {
    if (due.position() > next_start) break;
    const std::optional<TaskOfModule> brought = TaskBroughtBy(due.record.change);
    const bool is_of_module = brought && brought->module == module;
    if (is_of_module && !journal_.IsInQuarantine(due.record)) task = brought->task;
  }
  return task;
}

// A file that is saved unchanged would take the place of the version that `rollback` goes back to.
Json LiveRun::Exchange(const Change& change, std::shared_ptr<const Plugin> plugin, bool forget,
                       bool now) {
  const auto [module, task] = *TaskBroughtBy(change);
  const bool changes = forget || TaskToCome(module, now) != task;
  Json reply = TaskJson(module, TaskWithId(run_.record, task));
  reply["role"] = RoleName(graph_.FindTask(module));
  reply["takes_effect"] = changes ? Make(change, now, std::move(plugin)) : "already";
  return reply;
}

Json LiveRun::Rollback(const QueuedRequest& request) {
  const std::string name = Text(request.arguments, "name");
  const UniversalTask& module = graph_.FindTask(name);
  RollBackTask rollback{.module = name};
  std::shared_ptr<const Plugin> plugin;
  if (request.arguments.contains("version")) {
    const TaskRecord& version = FindVersion(run_.record, name, Text(request.arguments, "version"));
    CheckIsGood(version);
    plugin = maker_.LoadKept(version);
    graph_.CheckSwap(name, *plugin);
    rollback.task = version.id;
  } else {
    plugin = module.FindPrevious().plugin();
    rollback.task = module.FindPrevious().id();
  }
  return Exchange(rollback, std::move(plugin), false, Flag(request.arguments, "now"));
}

Json LiveRun::Unload(const QueuedRequest& request) {
  return MakeNow(UnloadShadow{Text(request.arguments, "name")});
}

Json LiveRun::Promote(const QueuedRequest& request) {
  const std::string name = Text(request.arguments, "name");
  const bool now = Flag(request.arguments, "now");
  graph_.CheckPromote(name, now && position_.step != 0);
  const PromoteTask promote{.module = name, .forget = Flag(request.arguments, "forget")};
  Json reply = TaskJson(name, TaskWithId(run_.record, graph_.FindTask(name).instance().id()));
  reply["takes_effect"] = Make(promote, now);
  return reply;
}

Json LiveRun::Set(const QueuedRequest& request) {
  const Json& arguments = request.arguments;
  const std::string name = Text(arguments, "name");
  const Parameter& parameter = graph_.FindParameter(name);
  if (arguments.contains("value")) {
    const std::string takes_effect = Make(ReadValue(arguments, parameter, name), true);
    Json reply = ParametersJson(graph_, name);
    reply["takes_effect"] = takes_effect;
    return reply;
  }
  const ScheduleParameter schedule = ReadSchedule(arguments, name);
  CheckSchedule(schedule, parameter);
  return {{"name", name},
          {"from", ToJson(schedule.from)},
          {"to", ToJson(schedule.to)},
          {"episodes", schedule.episodes},
          {"first_episode", position_.next_whole_episode()},
          {"takes_effect", Make(schedule, true)}};
}

Json LiveRun::Hold(const QueuedRequest& request) {
  const std::string name = Text(request.arguments, "name");
  const ParameterValue value = ValueFromJson(request.arguments.at("value"), name);
  graph_.CheckGoal(name);
  return MakeNow(HoldGoal{name, value});
}

Json LiveRun::Release(const QueuedRequest& request) {
  const std::string name = Text(request.arguments, "name");
  graph_.CheckGoal(name);
  return MakeNow(ReleaseGoal{name});
}

Json LiveRun::Connect(const QueuedRequest& request) {
  return MakeNow(ConnectPorts{Text(request.arguments, "first"), Text(request.arguments, "second")});
}

Json LiveRun::Disconnect(const QueuedRequest& request) {
  return MakeNow(
      DisconnectPorts{Text(request.arguments, "first"), Text(request.arguments, "second")});
}

Json LiveRun::ModuleAdd(const QueuedRequest& request) {
  AddModule add{.type = Text(request.arguments, "type"),
                .module = Text(request.arguments, "name"),
                .parameters = {}};
  const Json parameters = request.arguments.value("parameters", Json::object());
  for (const auto& [name, value] : parameters.items()) {
    add.parameters.emplace_back(name, ValueFromJson(value, name));
  }
  add.parameters = graph_.Resolved(add.type, add.module, add.parameters);
  return MakeNow(add);
}

Json LiveRun::ModuleRemove(const QueuedRequest& request) {
  return MakeNow(RemoveModule{Text(request.arguments, "name")});
}

}  // namespace runtime
