#include "runtime/live/control/live_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/variant/overloaded.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/record_error.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

constexpr std::chrono::milliseconds kBetweenLooks{100};  // for a signal, during a pause

// The module that comes or goes with a change.
std::optional<std::string> ComingOrGoing(const Change& change) {
  using Result = std::optional<std::string>;
  return std::visit(
      variant::Overloaded{
          [](const variant::OneOf<LoadShadow, UnloadShadow, AddModule, RemoveModule> auto& each)
              -> Result { return each.module; },
          [](const variant::OneOf<SwapTask, RollBackTask, PromoteTask, SetParameter,
                                  ScheduleParameter, HoldGoal, ReleaseGoal, ConnectPorts,
                                  DisconnectPorts, PutInQuarantine, UnknownChange> auto&)
              -> Result { return std::nullopt; },
      },
      change);
}

}  // namespace

LiveRun::LiveRun(const RunParts& run, Progress& progress, WhenDone when_done,
                 const StopRequest& stop)
    : run_(run),
      progress_(progress),
      when_done_(when_done),
      stop_(stop),
      graph_(run.graph, run.types, run.context),
      journal_(run.database),
      maker_(graph_, schedules_, run.record, run.folder),
      loader_(run.folder, run.record),
      view_(run.context) {
  if (journal_.bad_tasks().contains(run.record.tasks.front().id)) {
    throw UserError(fmt::format(
        "{}: the task that this run began with has crashed (`trainer show {}` tells when), so the "
        "run cannot continue; start another one",
        run.folder.string(), run.folder.string()));
  }
}

LiveRun::~LiveRun() {
  queue_.Close();
  for (const ReplyHandler& reply : waiting_for_checkpoint_) {
    reply({false, {}, "the trainer has ended"});
  }
}

void LiveRun::Publish(const Json& event) {
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

std::set<std::string> LiveRun::BeforeRestore(int64_t episode) {
  for (const EpisodeRecord& each : run_.database.ReadEpisodes()) {
    if (each.number <= episode) RepeatEpisode(each);
  }
  position_ = {episode + 1, 0};
  episodes_done_ = episode;
  recent_.clear();
  graph_has_changed_ = false;
  for (const ChangeRecord& change : journal_.passed_over()) NoteNotAgain(change);
  return not_again_;
}

// A checkpoint may have another opinion of whether its module is there.
void LiveRun::NoteNotAgain(const ChangeRecord& change) {
  if (auto module = ComingOrGoing(change.change)) not_again_.insert(*std::move(module));
}

// Schedules go on with every episode: which of them ended, and when, depends on what was changed
// meanwhile. After the last step nothing was changed any more, whatever was planned for later.
void LiveRun::RepeatEpisode(const EpisodeRecord& episode) {
  RepeatPast({episode.number, 0});
  schedules_.Apply(episode.number, graph_);
  RepeatPast({episode.number, episode.steps - 1});
}

void LiveRun::RepeatPast(const RunPosition& position) {
  position_ = position;
  while (const std::optional<DueChange> due = journal_.TakeDue(position_)) {
    if (TryAgain(*due)) NoteNotAgain(due->record);
  }
}

bool LiveRun::AtSafePoint(int64_t episode, int64_t step) {
  position_ = {episode, step};
  const bool has_something_to_do = step == 0 || journal_.has_due(position_) ||
                                   queue_.has_requests() || counts_ || state_ == State::kPaused;
  if (!has_something_to_do) return false;
  DoDueChanges();
  CountDown();
  ServeQueue();
  WaitInPause();
  if (step == 0) schedules_.Apply(episode, graph_);
  return std::exchange(graph_has_changed_, false);
}

// Who comes to watch meanwhile sees the robot where it is. Before an episode it is nowhere.
void LiveRun::WaitInPause() {
  while (state_ == State::kPaused && !stops()) {
    queue_.WaitFor(kBetweenLooks);
    ServeQueue();
    if (position_.step == 0) continue;
    const TaskModules tasks = FindTaskModules(graph_.graph(), graph_.learner());
    view_.AfterStep(position_.episode, position_.step,
                    {run_.graph.FindOnly<Environment>(), graph_.learner(), tasks});
  }
  if (state_ == State::kPaused) SetState(State::kRunning);  // to the end of the episode
}

int64_t LiveRun::undisturbed_until() const {
  if (counts_ || state_ == State::kPaused) return position_.episode - 1;
  if (journal_.due().empty()) return std::numeric_limits<int64_t>::max();
  return journal_.due().front().position().episode - 1;
}

void LiveRun::Anticipate(int64_t episode, ModuleGraph& copy) const {
  schedules_.Anticipate(episode, copy);
}

void LiveRun::CountDown() {
  if (!counts_ || (*counts_ == StepUnit::kEpisode && position_.step != 0)) return;
  if (steps_left_-- > 0) return;
  counts_.reset();
  SetState(State::kPaused);
}

void LiveRun::DoDueChanges() {
  while (const std::optional<DueChange> due = journal_.TakeDueNow(position_)) {
    // What the run has gone on without now, it goes on without whenever it is repeated.
    if (const auto why = TryAgain(*due)) journal_.Quarantine(position_, due->record, *why);
  }
}

std::optional<std::string> LiveRun::TryAgain(const DueChange& due) {
  try {
    Do(due);
    return std::nullopt;
  } catch (const RecordError&) {
    throw;  // would be done if its plugin were there: the run must not go on without it
  } catch (const std::exception& error) {
    const std::string text =
        fmt::format("warning: {}: not done again: {}", due.record.text, error.what());
    progress_.Warn(text);
    OnWarning(text);
    return error.what();
  }
}

void LiveRun::Do(const DueChange& due) {
  maker_.Do(due.record.change,
            {.episode = due.position().next_whole_episode(), .plugin = due.plugin});
  NoteDone(due.record);
}

void LiveRun::NoteDone(const ChangeRecord& record) {
  graph_has_changed_ = true;
  recent_.push_back(record);
  Publish({{"event", "change"},
           {"id", record.id},
           {"episode", record.episode},
           {"step", record.step},
           {"kind", KindOf(record.change)},
           {"text", record.text}});
}

void LiveRun::AfterEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics,
                           bool checkpoint_was_saved) {
  episodes_done_ = episode.number;
  constexpr double kKept = 0.9;
  simulated_seconds_ = kKept * simulated_seconds_ + episode.simulated_seconds;
  wall_seconds_ = kKept * wall_seconds_ + episode.wall_seconds;
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
  Json event = EpisodeJson(episode, run_.record);
  event["event"] = "episode";
  events_->Publish(event);
}

bool LiveRun::PlanMore(int64_t episodes_done) {
  if (when_done_ == WhenDone::kEnd) return false;
  position_ = {episodes_done + 1, 0};
  DoDueChanges();  // before others come that take effect here
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
