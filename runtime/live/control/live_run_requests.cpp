// What clients ask of a run: how each request is answered.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "runtime/base/suggestion.h"
#include "runtime/live/control/answers.h"
#include "runtime/live/control/live_run.h"
#include "runtime/live/control/parameter_json.h"
#include "runtime/live/control/versions.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/task_record.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

constexpr const char* kOfSchedule[] = {"from", "to", "episodes"};

// JSON has no infinity: null before the first episode.
Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void CheckSchedule(const ScheduleParameter& schedule, const Parameter& parameter) {
  const std::string& name = schedule.parameter;
  if (!std::holds_alternative<double*>(parameter.target) &&
      !std::holds_alternative<int64_t*>(parameter.target) &&
      !std::holds_alternative<int*>(parameter.target)) {
    throw UserError(fmt::format("`{}` is no number, so it has no schedule", name));
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

AddModule ReadModule(const Json& arguments) {
  AddModule add{.type = arguments.at("type").get<std::string>(),
                .module = arguments.at("name").get<std::string>(),
                .parameters = {}};
  const Json parameters = arguments.value("parameters", Json::object());
  for (const auto& [name, value] : parameters.items()) {
    add.parameters.emplace_back(name, ValueFromJson(value, name));
  }
  return add;
}

Change PlainChange(const std::string& command, const Json& arguments) {
  const auto text = [&](const char* key) { return arguments.at(key).get<std::string>(); };
  if (command == UnloadShadow::kKind) return UnloadShadow{text("name")};
  if (command == ConnectPorts::kKind) return ConnectPorts{text("first"), text("second")};
  if (command == DisconnectPorts::kKind) return DisconnectPorts{text("first"), text("second")};
  if (command == AddModule::kKind) return ReadModule(arguments);
  return RemoveModule{text("name")};
}

}  // namespace

Json LiveRun::Answer(const QueuedRequest& request) {
  if (auto answer = Look(request.request)) return *std::move(answer);
  if (auto answer = Steer(request)) return *std::move(answer);
  const std::string& command = request.request.command;
  const Json& arguments = request.request.arguments;
  if (command == "load" || command == "swap") return LoadOrSwap(request);
  if (command == "rollback") return Rollback(arguments);
  if (command == "promote") return Promote(arguments);
  if (command == "set") return Set(arguments);
  return {{"takes_effect", Make(PlainChange(command, arguments), true)}};
}

std::optional<Json> LiveRun::Look(const Request& request) const {
  const std::string& command = request.command;
  if (command == "status") return StatusJson();
  if (command == "list") return ListJson(graph_, schedules_, run_.record);
  if (command == "get") {
    return ParametersJson(graph_, request.arguments.at("name").get<std::string>());
  }
  if (command == "graph") {
    return GraphAnswer(graph_, request.arguments.value("format", std::string("text")));
  }
  return std::nullopt;
}

std::optional<Json> LiveRun::Steer(const QueuedRequest& request) {
  const std::string& command = request.request.command;
  if (command == "pause") {
    if (state_ == State::kRunning) SetState(State::kPaused);
    return StatusJson();
  }
  if (command == "resume") return GoOn(request.request.arguments);
  if (command == "step") return StepOn(request.request.arguments);
  if (command == "save") return Json{{"episode", episodes_done_}};
  if (command == "stop") {
    stop_was_asked_for_ = true;
    return Json{{"stops", fmt::format("after episode {}",
                                      position_.step == 0 ? episodes_done_ : position_.episode)}};
  }
  return std::nullopt;
}

Json LiveRun::GoOn(const Json& arguments) {
  if (arguments.contains("episodes")) {
    const auto episodes = arguments.at("episodes").get<int64_t>();
    if (episodes <= episodes_done_) {
      throw UserError(
          fmt::format("the run has {} episodes already: name a larger number", episodes_done_));
    }
    run_.database.SetEpisodesPlanned(episodes);
    run_.record.episodes_planned = episodes;
  }
  if (episodes_done_ >= run_.record.episodes_planned) {
    throw UserError(fmt::format(
        "all {} planned episodes are done: say how many there are to be in all, with `episodes`",
        run_.record.episodes_planned));
  }
  counts_.reset();
  SetState(State::kRunning);
  return StatusJson();
}

Json LiveRun::StepOn(const Json& arguments) {
  const std::string unit = arguments.value("unit", std::string("step"));
  const int64_t count = arguments.value("count", int64_t{1});
  if (unit != "step" && unit != "episode") {
    throw UserError(fmt::format("`{}` is no unit{}", unit, Suggestion(unit, {"step", "episode"})));
  }
  if (count < 1) throw UserError("`count` must be at least 1");
  if (state_ == State::kFinished) return GoOn({});  // says what is missing
  counts_ = unit == "step" ? StepUnit::kStep : StepUnit::kEpisode;
  steps_left_ = count - 1;
  SetState(State::kRunning);
  return StatusJson();
}

Json LiveRun::StatusJson() const {
  static constexpr const char* kNames[] = {"running", "paused", "finished"};
  const double wall = last_episode_.wall_seconds;
  return {{"run", run_.folder.string()},
          {"task", graph_.active_task().plugin().name},
          {"robot", run_.record.robot},
          {"state", kNames[static_cast<int>(state_)]},
          {"episode", position_.episode},
          {"step", position_.step},
          {"time", position_.step == 0 ? 0.0 : graph_.environment().time()},
          {"episodes_done", episodes_done_},
          {"episodes_planned", run_.record.episodes_planned},
          {"speed", wall > 0 ? last_episode_.simulated_seconds / wall : 0.0},
          {"last_return", statistics_.last()},
          {"mean_return", statistics_.mean()},
          {"best_return", FiniteOrNull(statistics_.best())},
          {"version", run_.record.version},
          {"pid", getpid()}};
}

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

Json LiveRun::LoadOrSwap(const QueuedRequest& request) {
  const Json& arguments = request.request.arguments;
  const std::string& command = request.request.command;
  const Plugin& plugin = *request.task.plugin;
  const std::string name = arguments.value("name", std::string(plugin.table().name));
  TaskRecord task = DescribeTask(plugin.table(), name);
  task.plugin = request.task.kept;
  CheckIsGood(task);
  Json reply;
  if (command == "swap") {
    graph_.CheckSwap(name, plugin);
    const bool forget = arguments.value("forget", false);
    const SwapTask swap{.module = name, .task = RecordTask(std::move(task)).id, .forget = forget};
    reply = Exchange(swap, forget, arguments.value("now", false));
  } else {
    graph_.CheckLoad(name, plugin);
    const TaskRecord& loaded = RecordTask(std::move(task));
    reply = TaskJson(name, loaded);
    Make(LoadShadow{.module = name, .task = loaded.id}, true);
    // It sleeps until then.
    reply["takes_effect"] = fmt::format("episode {}", position_.next_whole_episode());
  }
  if (!request.task.messages.empty()) reply["messages"] = request.task.messages;
  return reply;
}

int64_t LiveRun::TaskToCome(const std::string& module, bool now) const {
  int64_t task = graph_.FindTask(module).instance().id();
  if (now || position_.step == 0) return task;
  const RunPosition next_start = {position_.episode + 1, 0};
  for (const ChangeRecord& due : journal_.due()) {
    if (RunPosition{due.episode, due.step} > next_start) break;
    const std::optional<TaskOfModule> brought = TaskBroughtBy(due.change);
    const bool is_of_module = brought && brought->module == module;
    if (is_of_module && !journal_.IsInQuarantine(due)) task = brought->task;
  }
  return task;
}

// A file that is saved unchanged would take the place of the version that `rollback` goes back to.
Json LiveRun::Exchange(const Change& change, bool forget, bool now) {
  const auto [module, task] = *TaskBroughtBy(change);
  const bool changes = forget || TaskToCome(module, now) != task;
  Json reply = TaskJson(module, TaskWithId(run_.record, task));
  reply["role"] = RoleName(graph_.FindTask(module));
  reply["takes_effect"] = changes ? Make(change, now) : "already";
  return reply;
}

Json LiveRun::Rollback(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  int64_t task = 0;
  if (arguments.contains("version")) {
    const UniversalTask& module = graph_.FindTask(name);
    const TaskRecord& version =
        FindVersion(run_.record, module.name(), arguments.at("version").get<std::string>());
    CheckIsGood(version);
    const Plugin plugin(FindKeptPlugin(run_.folder, version.plugin), version.task_file);
    graph_.CheckSwap(name, plugin);
    task = version.id;
  } else {
    task = graph_.FindTask(name).FindPrevious().id();
  }
  return Exchange(RollBackTask{.module = name, .task = task}, false, arguments.value("now", false));
}

Json LiveRun::Promote(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const bool now = arguments.value("now", false);
  graph_.CheckPromote(name, now && position_.step != 0);
  const PromoteTask promote{.module = name, .forget = arguments.value("forget", false)};
  Json reply = TaskJson(name, TaskWithId(run_.record, graph_.FindTask(name).instance().id()));
  reply["takes_effect"] = Make(promote, now);
  return reply;
}

Json LiveRun::Set(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
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

}  // namespace runtime
