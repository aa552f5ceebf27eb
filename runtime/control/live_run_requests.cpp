// What clients ask of a run: how each request is answered.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "runtime/control/answers.h"
#include "runtime/control/live_run.h"
#include "runtime/control/parameter_json.h"
#include "runtime/module/suggestion.h"
#include "runtime/run/task_record.h"

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
  if (command == "list") return ListJson(network_, schedules_, run_.record);
  if (command == "get") {
    return ParametersJson(network_, request.arguments.at("name").get<std::string>());
  }
  if (command == "graph") {
    return GraphAnswer(network_, request.arguments.value("format", std::string("text")));
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
          {"task", network_.active_task().plugin().name},
          {"robot", run_.record.robot},
          {"state", kNames[static_cast<int>(state_)]},
          {"episode", position_.episode},
          {"step", position_.step},
          {"time", position_.step == 0 ? 0.0 : network_.environment().time()},
          {"episodes_done", episodes_done_},
          {"episodes_planned", run_.record.episodes_planned},
          {"speed", wall > 0 ? last_episode_.simulated_seconds / wall : 0.0},
          {"last_return", statistics_.last()},
          {"mean_return", statistics_.mean()},
          {"best_return", FiniteOrNull(statistics_.best())},
          {"version", run_.record.version},
          {"pid", getpid()}};
}

void LiveRun::CheckIsGood(const LoadedTask& task) const {
  for (const TaskRecord& known : run_.record.tasks) {
    if (known.plugin != task.kept || !journal_.bad_tasks().contains(known.id)) continue;
    throw UserError(
        fmt::format("`{}` has crashed in this run before: change it first", known.task));
  }
}

const TaskRecord& LiveRun::RecordTask(const std::string& module, const LoadedTask& task) {
  for (const TaskRecord& known : run_.record.tasks) {
    if (known.module == module && known.plugin == task.kept) return known;
  }
  TaskRecord record = DescribeTask(task.plugin->table(), module);
  record.plugin = task.kept;
  record.id = run_.database.AddTask(record);
  return run_.record.tasks.emplace_back(std::move(record));
}

Json LiveRun::LoadOrSwap(const QueuedRequest& request) {
  const Json& arguments = request.request.arguments;
  const std::string& command = request.request.command;
  const bool is_swap = command == "swap";
  const std::string name = arguments.value("name", std::string(request.task.plugin->table().name));
  CheckIsGood(request.task);
  if (is_swap) {
    network_.CheckSwap(name, *request.task.plugin);
  } else {
    network_.CheckLoad(name, *request.task.plugin);
  }
  const TaskRecord& task = RecordTask(name, request.task);
  Json data = {{"command", command}, {"name", name}, {"task", task.id}};
  if (arguments.value("forget", false)) data["forget"] = true;
  Json reply = TaskJson(name, task);
  // A shadow sleeps until the next episode anyway.
  reply["takes_effect"] = Make(Change(data), !is_swap || arguments.value("now", false));
  if (!is_swap) reply["takes_effect"] = fmt::format("episode {}", position_.next_whole_episode());
  if (!request.task.messages.empty()) reply["messages"] = request.task.messages;
  return reply;
}

Json LiveRun::Rollback(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const TaskRecord& task = TaskWithId(run_.record, network_.FindTask(name).FindPrevious().id());
  Json reply = TaskJson(name, task);
  reply["takes_effect"] = Make(Change({{"command", "rollback"}, {"name", name}, {"task", task.id}}),
                               arguments.value("now", false));
  return reply;
}

Json LiveRun::Promote(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const bool now = arguments.value("now", false);
  network_.CheckPromote(name, now && position_.step != 0);
  Json data = {{"command", "promote"}, {"name", name}};
  if (arguments.value("forget", false)) data["forget"] = true;
  Json reply = TaskJson(name, TaskWithId(run_.record, network_.FindTask(name).instance().id()));
  reply["takes_effect"] = Make(Change(std::move(data)), now);
  return reply;
}

Json LiveRun::SetParameter(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const Parameter& parameter = network_.FindParameter(name);
  Json data = {{"command", "set"}, {"name", name}};
  if (arguments.contains("value")) {
    for (const char* key : {"from", "to", "episodes"}) {
      if (!arguments.contains(key)) continue;
      throw UserError(
          fmt::format("`set {}`: a `value` has no `{}`, which is of a schedule", name, key));
    }
    data["value"] = ToJson(ValueFromJson(arguments.at("value"), parameter, name));
    const std::string takes_effect = Make(Change(std::move(data)), true);
    Json reply = ParametersJson(network_, name);
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
