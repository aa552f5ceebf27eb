#include "runtime/training/run/training.h"

#include <fmt/format.h>

#include "runtime/training/run/checkpoint.h"
#include "runtime/training/run/episode.h"

namespace runtime {
namespace {

std::vector<CurveRecord> CurvesOf(const Learner& learner, const Environment& environment) {
  std::vector<CurveRecord> curves;
  for (const LearnerCurve& curve : learner.curves()) {
    curves.push_back({curve.name, curve.unit, "", curve.doc});
  }
  for (const DrawnValue& drawn : environment.drawn()) {
    curves.push_back({drawn.name, drawn.unit, "", drawn.doc});
  }
  return curves;
}

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Training::Training(ModuleGraph& graph, const RunRecord& run, RunDatabase& database,
                   Progress& progress, TrainingHooks& hooks)
    : graph_(graph),
      run_(run),
      database_(database),
      progress_(progress),
      hooks_(hooks),
      environment_(graph.FindOnly<Environment>()),
      learner_(graph.FindOnly<Learner>()),
      tasks_(FindTaskModules(graph, learner_)),
      recorder_(environment_.pose_count(), environment_.time_step()),
      tape_(environment_, learner_),
      warnings_(run, [&progress, &hooks](const std::string& text) {
        progress.Warn(text);
        hooks.OnWarning(text);
      }) {}

void Training::RunSideBySide(int jobs, const ModuleTypes& types, const Context& context) {
  if (learner_.learns_within_episodes() || !environment_.WhyOnlyOne().empty()) return;
  ahead_ = std::make_unique<EpisodesAhead>(graph_, types, context, learner_, hooks_, jobs);
}

void Training::Restore() {
  const std::optional<Checkpoint> checkpoint = database_.ReadCheckpoint();
  // Before anything is deleted: of a damaged run nothing is.
  const std::vector<EpisodeRecord> episodes = database_.ReadEpisodes();
  const std::set<std::string> left_out = hooks_.BeforeRestore(checkpoint ? checkpoint->episode : 0);
  if (checkpoint) {
    LoadModules(graph_, checkpoint->state, left_out);
    episodes_done_ = checkpoint->episode;
  }
  tasks_ = FindTaskModules(graph_, learner_);
  database_.DeleteEpisodesAfter(episodes_done_);
  database_.SetLearnerCurves(CurvesOf(learner_, environment_));
  for (const EpisodeRecord& episode : episodes) {
    if (episode.number > episodes_done_) continue;
    statistics_.Add(episode);
    progress_.Recall(episode);
  }
  hooks_.AfterRestore(statistics_);
}

bool Training::stops(const StopRequest& stop) const {
  return stop.signal() != 0 || hooks_.wants_stop();
}

bool Training::Run(const StopRequest& stop) {
  RunPlannedEpisodes(stop);
  while (!stops(stop)) {
    database_.SetState(RunState::kFinished);
    if (!hooks_.PlanMore(episodes_done_)) break;
    database_.SetState(RunState::kRunning);
    RunPlannedEpisodes(stop);
  }
  const bool is_finished = episodes_done_ >= run_.episodes_planned;
  database_.SetState(is_finished ? RunState::kFinished : RunState::kInterrupted);
  return is_finished;
}

void Training::RunPlannedEpisodes(const StopRequest& stop) {
  while (episodes_done_ < run_.episodes_planned && !stops(stop)) {
    bool has_changed = AllowChanges(0);
    if (stops(stop)) return SaveBeforeStop(has_changed);
    const Clock::time_point start = Clock::now();
    if (Collector* collector = WaitForCollector(stop, has_changed)) {
      EpisodeRecord episode = ahead_->TakeOver(*collector);
      episode.wall_seconds = SecondsSince(start);
      Finish(episode, collector->task(), collector->recorder(), collector->tape(), stop);
      ahead_->Free(*collector);
    } else {
      if (hooks_.wants_stop()) return SaveBeforeStop(has_changed);
      const EpisodeRecord episode = RunNextEpisode(stop);
      Finish(episode, *tasks_.active, recorder_, tape_, stop);
    }
  }
}

Collector* Training::WaitForCollector(const StopRequest& stop, bool& has_changed) {
  if (ahead_ == nullptr) return nullptr;
  while (!hooks_.wants_stop()) {
    Collector* collector = ahead_->Plan(episodes_done_ + 1, run_.episodes_planned, tasks_);
    if (collector == nullptr || ahead_->IsDone(*collector)) return collector;
    NoteStop(stop);
    has_changed |= AllowChanges(0);
  }
  return nullptr;
}

void Training::Finish(const EpisodeRecord& episode, const UniversalTask& task,
                      const Recorder& recorder, const TapeRecorder& tape, const StopRequest& stop) {
  ++episodes_done_;
  const bool is_last = stops(stop) || episodes_done_ == run_.episodes_planned;
  const std::optional<Recording> recording = RecordingOf(episode, task, recorder);
  statistics_.Add(episode);
  const std::optional<Checkpoint> checkpoint = CheckpointIfDue(is_last);
  database_.AddEpisode(episode, recording, checkpoint, recording ? tape.Finish() : "");
  progress_.FinishEpisode(episode, statistics_);
  warnings_.About(episode, task, learner_);
  hooks_.AfterEpisode(episode, statistics_, checkpoint.has_value());
}

EpisodeRecord Training::RunNextEpisode(const StopRequest& stop) {
  const EpisodeModules modules = {environment_, learner_, tasks_};
  EpisodeWatcher* const watcher = hooks_.watcher();
  const auto after_step = [&](int64_t steps) {
    recorder_.Capture(steps, modules);
    tape_.Note(steps);
    if (watcher != nullptr) watcher->AfterStep(episodes_done_ + 1, steps, modules);
    NoteStop(stop);
    if (steps > 0 && !learner_.episode_over()) AllowChanges(steps);
  };
  return RunEpisode(episodes_done_ + 1, modules, after_step,
                    [&](const auto& drawn) { tape_.StartEpisode(drawn); });
}

bool Training::AllowChanges(int64_t step) {
  const bool has_changed = hooks_.AtSafePoint(episodes_done_ + 1, step);
  if (!has_changed) return false;
  tasks_ = FindTaskModules(graph_, learner_);
  if (ahead_ != nullptr) ahead_->StartOver();
  return true;
}

// What was changed after the last episode is no part of its checkpoint: then the one before has to
// do, and the changes are made again.
void Training::SaveBeforeStop(bool has_changed) {
  if (!has_changed && episodes_done_ > 0) {
    database_.WriteCheckpoint({episodes_done_, SaveModules(graph_)});
  }
}

void Training::NoteStop(const StopRequest& stop) {
  if (stop.signal() == 0 || stop_is_noted_) return;
  stop_is_noted_ = true;
  progress_.Warn(fmt::format("{} (saving) ... Ctrl-C again to stop at once", kStopNotice));
}

std::optional<Recording> Training::RecordingOf(const EpisodeRecord& episode,
                                               const UniversalTask& task,
                                               const Recorder& recorder) const {
  if (environment_.pose_count() == 0) return std::nullopt;  // there is nothing to see
  const bool is_best = statistics_.IsBest(episode);
  const bool is_due = run_.record_every > 0 && episode.number % run_.record_every == 0;
  const bool is_last = episode.number == run_.episodes_planned;  // what the run led to
  // What the robot did before a term could not be paid for the first time is worth seeing.
  const bool is_faulty = warnings_.HasNewFault(task);
  if (!is_best && !is_due && !is_last && !is_faulty) return std::nullopt;
  return recorder.Finish(is_best);
}

std::optional<Checkpoint> Training::CheckpointIfDue(bool is_last_episode) {
  const bool is_wanted = is_last_episode || hooks_.wants_checkpoint();
  if (!is_wanted && SecondsSince(last_checkpoint_) < run_.checkpoint_seconds) return std::nullopt;
  last_checkpoint_ = Clock::now();
  return Checkpoint{episodes_done_, SaveModules(graph_)};
}

}  // namespace runtime
