#include "runtime/training/run/training.h"

#include <fmt/format.h>
#include <taskc/largest_reward.h>

#include "runtime/training/run/checkpoint.h"
#include "runtime/training/run/episode.h"

namespace runtime {
namespace {

// "tasks/crawling.task:12"
std::string PlaceText(const taskc_plugin& plugin, const taskc_place& place) {
  return fmt::format("{}:{}", plugin.sources[place.source].file, place.line);
}

std::vector<CurveRecord> CurvesOf(const Learner& learner) {
  std::vector<CurveRecord> curves;
  for (const LearnerCurve& curve : learner.curves()) {
    curves.push_back({curve.name, curve.unit, "", curve.doc});
  }
  return curves;
}

}  // namespace

Training::Training(ModuleGraph& graph, const RunRecord& run, RunDatabase& database,
                   Progress& progress, TrainingHooks& hooks)
    : graph_(graph),
      run_(run),
      database_(database),
      progress_(progress),
      hooks_(hooks),
      environment_(graph.FindOnly<RobotEnvironment>()),
      learner_(graph.FindOnly<Learner>()),
      tasks_(FindTaskModules(graph, learner_)),
      recorder_(environment_.link_count(), environment_.time_step()) {}

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
  database_.SetLearnerCurves(CurvesOf(learner_));
  for (const EpisodeRecord& episode : episodes) {
    if (episode.number <= episodes_done_) statistics_.Add(episode);
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
    const bool has_changed = AllowChanges(0);
    if (stops(stop)) return SaveBeforeStop(has_changed);
    const EpisodeRecord episode = RunNextEpisode(stop);
    ++episodes_done_;
    const bool is_last = stops(stop) || episodes_done_ == run_.episodes_planned;
    const std::optional<Recording> recording = RecordingOf(episode);
    statistics_.Add(episode);
    const std::optional<Checkpoint> checkpoint = CheckpointIfDue(is_last);
    database_.AddEpisode(episode, recording, checkpoint);
    progress_.FinishEpisode(episode, statistics_);
    WarnAbout(episode);
    hooks_.AfterEpisode(episode, statistics_, checkpoint.has_value());
  }
}

EpisodeRecord Training::RunNextEpisode(const StopRequest& stop) {
  return RunEpisode(episodes_done_ + 1, {environment_, learner_, tasks_}, [&](int64_t steps) {
    if (steps == 0) recorder_.StartEpisode();
    CaptureFrame();
    NoteStop(stop);
    if (steps > 0 && !learner_.episode_over()) AllowChanges(steps);
  });
}

bool Training::AllowChanges(int64_t step) {
  const bool has_changed = hooks_.AtSafePoint(episodes_done_ + 1, step);
  if (has_changed) tasks_ = FindTaskModules(graph_, learner_);
  return has_changed;
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

void Training::CaptureFrame() {
  const std::span<float> frame = recorder_.NextFrame();
  if (!frame.empty()) environment_.CapturePose(frame);
}

void Training::Warn(const std::string& text) {
  progress_.Warn(text);
  hooks_.OnWarning(text);
}

void Training::WarnAbout(const EpisodeRecord& episode) {
  if (episode.active.end_kind == EndKindName(EndKind::kDiverged)) {
    Warn(fmt::format(
        "warning: episode {}: the simulation diverged after {:.3f} s; its last action was not "
        "learned from",
        episode.number, episode.simulated_seconds));
  }
  if (tasks_.active->fault_count() > 0) WarnAboutFaults(episode);
  if (learner_.passed_over_count() > 0) WarnAboutLearner(episode);
  if (episode.active.violations > 0) WarnAboutViolations(episode);
  WarnAboutObservations(episode);
}

void Training::WarnAboutFaults(const EpisodeRecord& episode) {
  const UniversalTask& task = *tasks_.active;
  std::string terms;
  for (size_t i = 0; i < task.faults().size(); ++i) {
    const Incidents& faults = task.faults()[i];
    const taskc_reward_term& term = task.plugin().terms[i];
    if (faults.count == 0) continue;
    terms += fmt::format("{}`{}` ({}) {}x, first at {:.3f} s", terms.empty() ? "" : "; ", term.name,
                         PlaceText(task.plugin(), term.place), faults.count, faults.first_time);
  }
  if (terms.empty()) terms = fmt::format("what `{}` pays in one event", task.plugin().name);
  Warn(fmt::format("warning: episode {}: not finite, or beyond {:g}, and so not paid: {}",
                   episode.number, TASKC_LARGEST_REWARD, terms));
}

void Training::WarnAboutObservations(const EpisodeRecord& episode) {
  const UniversalTask& task = *tasks_.active;
  std::string seen;
  for (size_t i = 0; i < task.observation_faults().size(); ++i) {
    const Incidents& faults = task.observation_faults()[i];
    if (faults.count == 0) continue;
    seen += fmt::format("{}`{}` {}x, first at {:.3f} s", seen.empty() ? "" : "; ",
                        task.plugin().observations[i].name, faults.count, faults.first_time);
  }
  if (seen.empty()) return;
  Warn(fmt::format("warning: episode {}: not finite, and 0 to the learner: {}", episode.number,
                   seen));
}

void Training::WarnAboutLearner(const EpisodeRecord& episode) {
  Warn(fmt::format(
      "warning: episode {}: {} of {} actions were not learned from, since that gave no finite "
      "values: the learner diverges; lower `{}.learning_rate`, or the rewards",
      episode.number, learner_.passed_over_count(), episode.actions, learner_.name()));
}

void Training::WarnAboutViolations(const EpisodeRecord& episode) {
  const UniversalTask& task = *tasks_.active;
  std::vector<bool>& noted = violations_noted_[episode.active.task];
  noted.resize(task.violations().size());
  for (size_t i = 0; i < noted.size(); ++i) {
    const Incidents& violations = task.violations()[i];
    if (violations.count == 0 || noted[i]) continue;
    noted[i] = true;
    const taskc_requirement& requirement = task.plugin().requirements[i];
    Warn(fmt::format(
        "warning: episode {}: {} requires `{}` ({}), which did not hold at {:.3f} s; such episodes "
        "are truncated and counted, and this is said once",
        episode.number, task.plugin().name, requirement.reason,
        PlaceText(task.plugin(), requirement.place), violations.first_time));
  }
}

std::optional<Recording> Training::RecordingOf(const EpisodeRecord& episode) const {
  const bool is_best = statistics_.IsBest(episode);
  const bool is_due = run_.record_every > 0 && episode.number % run_.record_every == 0;
  const bool is_last = episode.number == run_.episodes_planned;  // what the run led to
  if (!is_best && !is_due && !is_last) return std::nullopt;
  return recorder_.Finish(is_best);
}

std::optional<Checkpoint> Training::CheckpointIfDue(bool is_last_episode) {
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> since_last = now - last_checkpoint_;
  const bool is_wanted = is_last_episode || hooks_.wants_checkpoint();
  if (!is_wanted && since_last.count() < run_.checkpoint_seconds) return std::nullopt;
  last_checkpoint_ = now;
  return Checkpoint{episodes_done_, SaveModules(graph_)};
}

}  // namespace runtime
