// How requests come to the thread that trains, and how those are answered that look at the run or
// steer it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/variant/overloaded.h"
#include "runtime/base/child_process.h"
#include "runtime/base/suggestion.h"
#include "runtime/live/control/live_run.h"
#include "runtime/live/control/replies.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

// JSON has no infinity: null before the first episode.
Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

// On any thread.
void LiveRun::Handle(Request request, ReplyHandler reply) {
  const CommandSpec& command = FindCommand(request.command);
  QueuedRequest queued{&command, std::move(request.arguments), std::move(reply), {}};
  const ArgumentSpec* file = command.task_file();
  if (file == nullptr) return queue_.Push(std::move(queued));
  std::optional<std::string> text;
  if (queued.arguments.contains("text")) text = queued.arguments.at("text").get<std::string>();
  const std::filesystem::path task = queued.arguments.at(file->name).get<std::string>();
  if (const auto* aside = std::get_if<AsideHandler>(&HandlerOf(command))) {
    const auto done = [this, queued, aside = *aside](const BuiltPlugin& built) {
      queued.reply(DoAside(aside, queued.arguments, built));
    };
    return loader_.BuildOnly(task, done, std::move(text));
  }
  const auto push = [this, queued](LoadedTask loaded) {
    if (loaded.plugin == nullptr) return queued.reply({false, {}, std::move(loaded.messages)});
    queue_.Push({queued.command, queued.arguments, queued.reply, std::move(loaded)});
  };
  loader_.Load(task, push, std::move(text));
}

Reply LiveRun::DoAside(AsideHandler handler, const Json& arguments, const BuiltPlugin& task) {
  if (task.plugin.empty()) return {false, {}, task.messages};
  try {
    return {true, (this->*handler)(arguments, task), ""};
  } catch (const std::exception& error) {
    return {false, {}, error.what()};
  }
}

void LiveRun::ServeQueue() {
  if (!queue_.has_requests()) return;
  for (const QueuedRequest& request : queue_.TakeAll()) Serve(request);
}

void LiveRun::Serve(const QueuedRequest& request) {
  const auto done = [&](Json value) { request.reply({true, std::move(value), ""}); };
  try {
    std::visit(variant::Overloaded{
                   [&](LookHandler look) { done((this->*look)(request.arguments)); },
                   [](AsideHandler) {},  // never waits here
                   [&](ChangeHandler change) { done((this->*change)(request)); },
                   [&](LateHandler change) { (this->*change)(request); },
               },
               HandlerOf(*request.command));
  } catch (const std::exception& error) {
    request.reply({false, {}, error.what()});
  }
}

Json LiveRun::Status(const Json&) const { return StatusJson(); }

Json LiveRun::StatusJson() const {
  static constexpr const char* kNames[] = {"running", "paused", "finished"};
  return {{"run", run_.folder.string()},
          {"task", graph_.active_task().plugin().name},
          {"robot", run_.record.robot},
          {"state", kNames[static_cast<int>(state_)]},
          // When all are over there is no next one.
          {"episode", std::min(position_.episode, run_.record.episodes_planned)},
          {"step", position_.step},
          {"time", position_.step == 0 ? 0.0 : graph_.environment().time()},
          {"episodes_done", episodes_done_},
          {"episodes_planned", run_.record.episodes_planned},
          {"speed", speed()},
          {"last_return", statistics_.last()},
          {"mean_return", statistics_.mean()},
          {"best_return", FiniteOrNull(statistics_.best())},
          {"version", run_.record.version},
          {"pid", getpid()}};
}

Json LiveRun::List(const Json&) const { return ListJson(graph_, schedules_, run_.record); }

Json LiveRun::Get(const Json& arguments) const {
  return ParametersJson(graph_, arguments.at("name").get<std::string>());
}

Json LiveRun::Graph(const Json& arguments) const {
  return GraphReply(graph_, arguments.value("format", std::string("text")));
}

// In a process of its own: the task's code has not been tried yet.
Json LiveRun::Rescore(const Json& arguments, const BuiltPlugin& task) {
  if (!rescore_words_) throw UserError("nothing here judges recorded episodes");
  Json recorded = Json::array();
  for (const RecordedEpisode& each : RunDatabase::OpenToRead(run_.folder).ReadRecordedEpisodes()) {
    recorded.push_back(each.number);
  }
  if (recorded.empty()) throw UserError("no episode is recorded yet; the first one always is");
  const int64_t episode = arguments.value("episode", recorded.back().get<int64_t>());
  const ChildResult result = RunChild(rescore_words_(task.plugin, episode), Captured::kMessages,
                                      {.stop = loader_.stop_token()});
  if (result.was_too_slow) throw UserError("judging the episode took too long");
  const Json said = Json::parse(result.captured, nullptr, false);
  if (!result.is_success || !said.is_object()) {
    throw UserError(result.captured.empty() ? "the episode cannot be judged" : result.captured);
  }
  const Json& run = said.at("runs").at(0);
  if (run.at("episodes").empty()) throw UserError(run.at("left_out").at(0).get<std::string>());
  Json value = run.at("episodes").at(0);
  value["caveats"] = said.at("caveats");
  value["recorded"] = std::move(recorded);
  return value;
}

Json LiveRun::Pause(const QueuedRequest&) {
  if (state_ == State::kRunning) SetState(State::kPaused);
  return StatusJson();
}

Json LiveRun::Resume(const QueuedRequest& request) {
  if (request.arguments.contains("episodes")) {
    const auto episodes = request.arguments.at("episodes").get<int64_t>();
    if (episodes <= episodes_done_) {
      throw UserError(
          fmt::format("the run has {} episodes already: name a larger number", episodes_done_));
    }
    run_.database.SetEpisodesPlanned(episodes);
    run_.record.episodes_planned = episodes;
  }
  CheckEpisodesAreLeft();
  counts_.reset();
  SetState(State::kRunning);
  return StatusJson();
}

void LiveRun::CheckEpisodesAreLeft() const {
  if (episodes_done_ < run_.record.episodes_planned) return;
  throw UserError(fmt::format(
      "all {} planned episodes are done: say how many there are to be in all, with `episodes`",
      run_.record.episodes_planned));
}

Json LiveRun::Step(const QueuedRequest& request) {
  const std::string unit = request.arguments.value("unit", std::string("step"));
  const int64_t count = request.arguments.value("count", int64_t{1});
  if (unit != "step" && unit != "episode") {
    throw UserError(
        fmt::format("`{}` is not a unit{}", unit, Suggestion(unit, {"step", "episode"})));
  }
  if (count < 1) throw UserError("`count` must be at least 1");
  CheckEpisodesAreLeft();
  counts_ = unit == "step" ? StepUnit::kStep : StepUnit::kEpisode;
  steps_left_ = count - 1;
  SetState(State::kRunning);
  return StatusJson();
}

void LiveRun::Save(const QueuedRequest& request) {
  // Where all episodes are done, the last of them is in the checkpoint.
  if (state_ == State::kFinished) return request.reply({true, {{"episode", episodes_done_}}, ""});
  waiting_for_checkpoint_.push_back(request.reply);
}

Json LiveRun::Stop(const QueuedRequest&) {
  stop_was_asked_for_ = true;
  return {{"stops", fmt::format("after episode {}",
                                position_.step == 0 ? episodes_done_ : position_.episode)}};
}

}  // namespace runtime
