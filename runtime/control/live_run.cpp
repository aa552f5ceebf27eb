#include "runtime/control/live_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/control/answers.h"
#include "runtime/control/parameter_json.h"
#include "runtime/module/suggestion.h"
#include "runtime/run/progress.h"
#include "runtime/run/task_record.h"
#include "runtime/simulation/robot_environment.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

constexpr std::chrono::milliseconds kBetweenLooks{100};  // for a signal, during a pause

// JSON has no infinity: null before the first episode.
Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

int64_t FirstEpisodeAfter(const RunPosition& position) {
  return position.step == 0 ? position.episode : position.episode + 1;
}

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
  for (const char* key : {"from", "to"}) {
    const auto value = arguments.at(key).get<double>();
    if (parameter.minimum <= value && value <= parameter.maximum) continue;
    throw UserError(fmt::format("`{}` must lie in {} .. {}, and {} does not", name,
                                parameter.minimum, parameter.maximum, value));
  }
  constexpr double kExact = 9007199254740992;  // up to here every whole number is a double
  for (const char* key : {"from", "to"}) {
    const bool is_exact = std::abs(arguments.at(key).get<double>()) <= kExact;
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

LiveRun::LiveRun(const RunParts& run, Progress& progress, WhenDone when_done,
                 const StopRequest& stop)
    : run_(run),
      progress_(progress),
      when_done_(when_done),
      stop_(stop),
      network_(run.network, run.types, run.context),
      journal_(run.database),
      maker_(network_, schedules_, run.record, run.folder),
      loader_(run.folder) {
  if (journal_.bad_tasks().contains(run.record.tasks.front().id)) {
    throw UserError(fmt::format(
        "{}: the task that this run began with has crashed (`trainer show {}` tells when), so the "
        "run cannot go on; start another one",
        run.folder.string(), run.folder.string()));
  }
}

LiveRun::~LiveRun() {
  queue_.Close();
  for (const ReplyHandler& reply : waiting_for_checkpoint_) {
    reply({false, {}, "the trainer has ended"});
  }
}

void LiveRun::Publish(Json event) {
  if (events_ != nullptr) events_->Publish(event);
}

void LiveRun::SetState(State state) {
  if (state_ == state) return;
  state_ = state;
  Publish({{"event", "state"}, {"state", StatusJson().at("state")}});
}

void LiveRun::OnWarning(const std::string& text) {
  Publish({{"event", "warning"}, {"text", text}});
}

// ---- requests, on any thread

void LiveRun::Handle(Request request, ReplyHandler reply) {
  if (request.command != "load" && request.command != "swap") {
    return queue_.Push({std::move(request), std::move(reply), {}});
  }
  const std::filesystem::path file = request.arguments.at("file").get<std::string>();
  loader_.Load(file,
               [this, request = std::move(request), reply = std::move(reply)](LoadedTask task) {
                 if (task.plugin == nullptr) return reply({false, {}, std::move(task.messages)});
                 queue_.Push({request, reply, std::move(task)});
               });
}

// ---- the thread that trains

std::set<std::string> LiveRun::BeforeRestore(int64_t episode) {
  for (int64_t each = 1; each <= episode; ++each) RepeatEpisode(each);
  position_ = {episode + 1, 0};
  episodes_done_ = episode;
  recent_.clear();
  network_has_changed_ = false;
  std::set<std::string> left_out;
  for (const ChangeRecord& change : journal_.passed_over()) {
    const bool adds_a_module = change.kind == "load" || change.kind == "module_add";
    if (adds_a_module) left_out.insert(Change(Json::parse(change.data)).text("name"));
  }
  return left_out;
}

// Schedules go on with every episode: which of them ended, and when, depends on what was changed
// meanwhile.
void LiveRun::RepeatEpisode(int64_t episode) {
  position_ = {episode, 0};
  RepeatDueChanges();
  schedules_.Apply(episode, network_);
  position_ = {episode, std::numeric_limits<int64_t>::max()};
  RepeatDueChanges();
}

bool LiveRun::AtSafePoint(int64_t episode, int64_t step) {
  position_ = {episode, step};
  const bool has_something_to_do = step == 0 || journal_.has_due(position_) ||
                                   queue_.has_requests() || counts_ || state_ == State::kPaused;
  if (!has_something_to_do) return false;
  RepeatDueChanges();
  CountDown();
  ServeQueue();
  while (state_ == State::kPaused && !stops()) {
    queue_.WaitFor(kBetweenLooks);
    ServeQueue();
  }
  if (state_ == State::kPaused) SetState(State::kRunning);  // to the end of the episode
  if (step == 0) schedules_.Apply(episode, network_);
  return std::exchange(network_has_changed_, false);
}

void LiveRun::CountDown() {
  if (!counts_ || (*counts_ == StepUnit::kEpisode && position_.step != 0)) return;
  if (steps_left_-- > 0) return;
  counts_.reset();
  SetState(State::kPaused);
}

void LiveRun::RepeatDueChanges() {
  while (const std::optional<ChangeRecord> change = journal_.TakeDue(position_)) {
    try {
      Do(*change);
    } catch (const std::exception& error) {
      const std::string text =
          fmt::format("warning: {}: not done again: {}", change->text, error.what());
      progress_.Warn(text);
      OnWarning(text);
    }
  }
}

void LiveRun::Do(const ChangeRecord& record) {
  maker_.Do(Change(Json::parse(record.data)), FirstEpisodeAfter({record.episode, record.step}));
  NoteDone(record);
}

void LiveRun::NoteDone(const ChangeRecord& record) {
  network_has_changed_ = true;
  recent_.push_back(record);
  Publish({{"event", "change"},
           {"id", record.id},
           {"episode", record.episode},
           {"step", record.step},
           {"kind", record.kind},
           {"text", record.text}});
}

std::string LiveRun::Make(const Change& change, bool now) {
  const auto text = [&] { return change.Description(run_.record); };
  if (!now && position_.step != 0) {
    const RunPosition next_start = {position_.episode + 1, 0};
    journal_.AddDue(next_start, change.kind(), text(), change.data().dump());
    return fmt::format("episode {}", next_start.episode);
  }
  maker_.Do(change, FirstEpisodeAfter(position_));
  NoteDone(journal_.AddDone(position_, change.kind(), text(), change.data().dump()));
  return "now";
}

void LiveRun::ServeQueue() {
  if (!queue_.has_requests()) return;
  for (const QueuedRequest& request : queue_.TakeAll()) Serve(request);
}

void LiveRun::Serve(const QueuedRequest& request) {
  // Where all episodes are done, the last of them is in the checkpoint.
  if (request.request.command == "save" && state_ != State::kFinished) {
    waiting_for_checkpoint_.push_back(request.reply);
    return;
  }
  try {
    request.reply({true, Answer(request), ""});
  } catch (const std::exception& error) {
    request.reply({false, {}, error.what()});
  }
}

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
  const auto& environment = run_.network.FindAs<RobotEnvironment>("environment");
  const double wall = last_episode_.wall_seconds;
  return {{"run", run_.folder.string()},
          {"task", network_.active_task().plugin().name},
          {"robot", run_.record.robot},
          {"state", kNames[static_cast<int>(state_)]},
          {"episode", position_.episode},
          {"step", position_.step},
          {"time", position_.step == 0 ? 0.0 : environment.time()},
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
  if (!is_swap) reply["takes_effect"] = fmt::format("episode {}", FirstEpisodeAfter(position_));
  if (!request.task.messages.empty()) reply["messages"] = request.task.messages;
  return reply;
}

Json LiveRun::Rollback(const Json& arguments) {
  const std::string name = arguments.at("name").get<std::string>();
  const TaskInstance* previous = network_.FindTask(name).previous();
  if (previous == nullptr) {
    throw UserError(fmt::format("`{}` has no previous task: it was not swapped yet", name));
  }
  const TaskRecord& task = TaskWithId(run_.record, previous->id());
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
          {"first_episode", FirstEpisodeAfter(position_)},
          {"takes_effect", Make(Change(data), true)}};
}

void LiveRun::AfterEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics,
                           bool checkpoint_was_saved) {
  episodes_done_ = episode.number;
  last_episode_ = episode;
  statistics_ = statistics;
  std::erase_if(recent_,
                [&](const ChangeRecord& change) { return change.episode < episode.number; });
  if (checkpoint_was_saved) {
    for (const ReplyHandler& reply : waiting_for_checkpoint_) {
      reply({true, {{"episode", episode.number}}, ""});
    }
    waiting_for_checkpoint_.clear();
  }
  if (events_ == nullptr) return;
  Json event = Json::parse(EpisodeJson(episode, run_.record));
  event["event"] = "episode";
  events_->Publish(event);
}

bool LiveRun::PlanMore(int64_t episodes_done) {
  if (when_done_ == WhenDone::kEnd) return false;
  position_ = {episodes_done + 1, 0};
  RepeatDueChanges();  // before others come that take effect here
  SetState(State::kFinished);
  while (run_.record.episodes_planned <= episodes_done && !stops()) {
    queue_.WaitFor(kBetweenLooks);
    ServeQueue();
  }
  return !stops();
}

bool LiveRun::BlameLastChange(const std::string& why) {
  const auto last = std::find_if(recent_.rbegin(), recent_.rend(), CanBeBlamed);
  if (last == recent_.rend()) return false;
  journal_.Quarantine(position_, *last, why);
  return true;
}

}  // namespace runtime
