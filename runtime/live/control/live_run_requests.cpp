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

namespace runtime {
namespace {

using Json = nlohmann::json;

// JSON has no infinity: null before the first episode.
Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

void CheckSchedule(const Json& arguments, const Parameter& parameter, const std::string& name) {
  for (const char* key : {"from", "to", "episodes"}) {
    if (arguments.contains(key)) continue;
    throw UserError(fmt::format(
        "`set {}` needs a `value`, or `from`, `to` and `episodes` for a schedule", name));
  }
  if (!std::holds_alternative<double*>(parameter.target) &&
      !std::holds_alternative<int64_t*>(parameter.target) &&
      !std::holds_alternative<int*>(parameter.target)) {
    throw UserError(fmt::format("`{}` is no number, so it has no schedule", name));
  }
  if (!parameter.is_live) {
    throw UserError(fmt::format("`{}` has no effect after the start of a run", name));
  }
  constexpr double kExact = 9007199254740992;  // up to here every whole number is a double
  for (const char* key : {"from", "to"}) {
    const auto value = arguments.at(key).get<double>();
    parameter.CheckRange(name, value);
    const bool is_exact = std::abs(value) <= kExact;
    if (is_exact || std::holds_alternative<double*>(parameter.target)) continue;
    throw UserError(fmt::format("a schedule of `{}` has no number as large as {}", name,
                                arguments.at(key).dump()));
  }
  constexpr int64_t kMost = 1'000'000'000;
  const auto episodes = arguments.at("episodes").get<int64_t>();
  if (episodes < 1 || episodes > kMost) {
    throw UserError(
        fmt::format("`episodes` must lie in 1 .. {}, and {} does not", kMost, episodes));
  }
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
  if (command == "set") return SetParameter(arguments);
  Json data = arguments;
  data["command"] = command;
  return {{"takes_effect", Make(Change(std::move(data)), true)}};
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
    Json data = {{"command", command}, {"name", name}, {"task", RecordTask(std::move(task)).id}};
    if (arguments.value("forget", false)) data["forget"] = true;
    reply = Exchange(std::move(data), arguments.value("now", false));
  } else {
    graph_.CheckLoad(name, plugin);
    const TaskRecord& loaded = RecordTask(std::move(task));
    reply = TaskJson(name, loaded);
    Make(Change({{"command", command}, {"name", name}, {"task", loaded.id}}), true);
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
    const Change change(Json::parse(due.data));
    const bool is_of_module = change.task() != 0 && change.text("name") == module;
    if (is_of_module && !journal_.IsInQuarantine(due)) task = change.task();
  }
  return task;
}

// A file that is saved unchanged would take the place of the version that `rollback` goes back to.
Json LiveRun::Exchange(Json data, bool now) {
  const Change change(std::move(data));
  const std::string name = change.text("name");
  const bool changes = change.flag("forget") || TaskToCome(name, now) != change.task();
  Json reply = TaskJson(name, TaskWithId(run_.record, change.task()));
  reply["role"] = RoleName(graph_.FindTask(name));
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
  return Exchange({{"command", "rollback"}, {"name", name}, {"task", task}},
                  arguments.value("now", false));
}

Json LiveRun::Promote(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const bool now = arguments.value("now", false);
  graph_.CheckPromote(name, now && position_.step != 0);
  Json data = {{"command", "promote"}, {"name", name}};
  if (arguments.value("forget", false)) data["forget"] = true;
  Json reply = TaskJson(name, TaskWithId(run_.record, graph_.FindTask(name).instance().id()));
  reply["takes_effect"] = Make(Change(std::move(data)), now);
  return reply;
}

Json LiveRun::SetParameter(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const Parameter& parameter = graph_.FindParameter(name);
  Json data = {{"command", "set"}, {"name", name}};
  if (arguments.contains("value")) {
    for (const char* key : {"from", "to", "episodes"}) {
      if (!arguments.contains(key)) continue;
      throw UserError(
          fmt::format("`set {}`: a `value` has no `{}`, which is of a schedule", name, key));
    }
    data["value"] = ToJson(ValueFromJson(arguments.at("value"), parameter, name));
    const std::string takes_effect = Make(Change(std::move(data)), true);
    Json reply = ParametersJson(graph_, name);
    reply["takes_effect"] = takes_effect;
    return reply;
  }
  CheckSchedule(arguments, parameter, name);
  for (const char* key : {"from", "to", "episodes"}) data[key] = arguments.at(key);
  return {{"name", name},
          {"from", data["from"]},
          {"to", data["to"]},
          {"episodes", data["episodes"]},
          {"first_episode", position_.next_whole_episode()},
          {"takes_effect", Make(Change(data), true)}};
}

}  // namespace runtime
