#include "runtime/run/training.h"

#include <fmt/format.h>

#include <ctime>

#include "runtime/run/checkpoint.h"

namespace runtime {
namespace {

// "tasks/crawling.task:12"
std::string PlaceText(const taskc_plugin& plugin, const taskc_place& place) {
  return fmt::format("{}:{}", plugin.sources[place.source].file, place.line);
}

}  // namespace

Training::Training(Network& network, const RunRecord& run, RunDatabase& database,
                   Progress& progress)
    : network_(network),
      run_(run),
      database_(database),
      progress_(progress),
      environment_(network.FindAs<RobotEnvironment>("environment")),
      task_(network.FindAs<UniversalTask>("task")),
      learner_(network.FindAs<PengQLambda>("learner")),
      recorder_(environment_.link_count(), environment_.control_time_step()) {}

void Training::Restore() {
  const std::optional<Checkpoint> checkpoint = database_.ReadCheckpoint();
  if (checkpoint) {
    LoadModules(network_, checkpoint->state);
    episodes_done_ = checkpoint->episode;
  }
  database_.DeleteEpisodesAfter(episodes_done_);
  for (const EpisodeRecord& episode : database_.ReadEpisodes()) statistics_.Add(episode);
}

bool Training::Run(const StopRequest& stop) {
  bool stops = stop.signal() != 0;
  while (episodes_done_ < run_.episodes_planned && !stops) {
    const EpisodeRecord episode = RunEpisode(stop);
    ++episodes_done_;
    stops = stop.signal() != 0;
    const bool is_last = stops || episodes_done_ == run_.episodes_planned;
    const std::optional<Recording> recording = RecordingOf(episode);
    statistics_.Add(episode);
    database_.AddEpisode(episode, recording, CheckpointIfDue(is_last));
    progress_.FinishEpisode(episode, statistics_);
    WarnAbout(episode);
  }
  const bool is_finished = episodes_done_ >= run_.episodes_planned;
  database_.SetState(is_finished ? RunState::kFinished : RunState::kInterrupted);
  return is_finished;
}

EpisodeRecord Training::RunEpisode(const StopRequest& stop) {
  const Clock::time_point start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  EpisodeRecord episode;
  episode.number = episodes_done_ + 1;
  environment_.StartEpisode();
  recorder_.StartEpisode();
  CaptureFrame();
  while (!learner_.episode_over()) {
    environment_.StepControl();
    ++episode.steps;
    CaptureFrame();
    if (stop.signal() != 0 && !stop_is_noted_) {
      stop_is_noted_ = true;
      progress_.Warn(
          "stopping after this episode (once more: at once, back to the last checkpoint)");
    }
  }
  const EpisodeEnd& end = learner_.episode_end();
  episode.active.task = run_.tasks.front().id;
  episode.active.episode_return = learner_.episode_return();
  episode.active.end_kind = EndKindName(end.kind);
  episode.active.end_reason = end.reason;
  episode.actions = learner_.action_count();
  episode.simulated_seconds = environment_.time();
  episode.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  episode.cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  episode.active.faults = task_.fault_count();
  for (const Incidents& violations : task_.violations())
    episode.active.violations += violations.count;
  episode.active.terms.assign(task_.term_sums().begin(), task_.term_sums().end());
  episode.active.metrics.assign(task_.metrics().begin(), task_.metrics().end());
  episode.active.logs.assign(task_.logs().begin(), task_.logs().end());
  return episode;
}

void Training::CaptureFrame() {
  const std::span<float> frame = recorder_.NextFrame();
  if (!frame.empty()) environment_.CapturePose(frame);
}

void Training::WarnAbout(const EpisodeRecord& episode) {
  if (episode.active.end_kind == EndKindName(EndKind::kDiverged)) {
    progress_.Warn(fmt::format(
        "warning: episode {}: the simulation diverged after {:.3f} s; its last action was not "
        "learned from",
        episode.number, episode.simulated_seconds));
  }
  if (episode.active.faults > 0) WarnAboutFaults(episode);
  if (episode.active.violations > 0) WarnAboutViolations(episode);
}

void Training::WarnAboutFaults(const EpisodeRecord& episode) {
  std::string terms;
  for (size_t i = 0; i < run_.tasks.front().terms.size(); ++i) {
    const Incidents& faults = task_.faults()[i];
    if (faults.count == 0) continue;
    terms += fmt::format("{}`{}` ({}) {}x, first at {:.3f} s", terms.empty() ? "" : "; ",
                         run_.tasks.front().terms[i].name,
                         PlaceText(task_.plugin(), task_.plugin().terms[i].place), faults.count,
                         faults.first_time);
  }
  progress_.Warn(
      fmt::format("warning: episode {}: not finite and so not paid: {}", episode.number, terms));
}

void Training::WarnAboutViolations(const EpisodeRecord& episode) {
  violations_noted_.resize(task_.violations().size());
  for (size_t i = 0; i < violations_noted_.size(); ++i) {
    const Incidents& violations = task_.violations()[i];
    if (violations.count == 0 || violations_noted_[i]) continue;
    violations_noted_[i] = true;
    const taskc_requirement& requirement = task_.plugin().requirements[i];
    progress_.Warn(fmt::format(
        "warning: episode {}: {} requires `{}` ({}), which did not hold at {:.3f} s; such episodes "
        "are truncated and counted, and this is said once",
        episode.number, run_.tasks.front().task, requirement.reason,
        PlaceText(task_.plugin(), requirement.place), violations.first_time));
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
  if (!is_last_episode && since_last.count() < run_.checkpoint_seconds) return std::nullopt;
  last_checkpoint_ = now;
  return Checkpoint{episodes_done_, SaveModules(network_)};
}

}  // namespace runtime
