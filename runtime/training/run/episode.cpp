#include "runtime/training/run/episode.h"

#include <chrono>

#include "runtime/base/thread_seconds.h"
#include "runtime/core/module/end_kind_name.h"

namespace runtime {

void StartEpisode(int64_t number, const EpisodeModules& modules, const NoteStart& note_start) {
  modules.environment.SetNextEpisode(number);
  modules.learner.SetNextEpisode(number);
  modules.tasks.active->SetNextEpisode(number);
  for (UniversalTask* shadow : modules.tasks.shadows) shadow->SetNextEpisode(number);
  std::optional<robot::StartState> drawn;
  modules.environment.StartDrawnEpisode(
      [&](uint32_t attempt) { return drawn = modules.tasks.active->DrawStart(attempt); });
  if (note_start) note_start(drawn);
}

EpisodeRecord RecordOfEpisode(int64_t number, int64_t steps, const EpisodeModules& modules) {
  const Learner& learner = modules.learner;
  EpisodeRecord episode;
  episode.number = number;
  episode.steps = steps;
  episode.actions = learner.action_count();
  episode.simulated_seconds = modules.environment.time();
  episode.active = EvaluationOf(*modules.tasks.active);
  // What the learner was paid, and why it ended the episode, whoever wanted it.
  episode.active.episode_return = learner.episode_return();
  episode.active.end_kind = EndKindName(learner.episode_end().kind);
  episode.active.end_reason = learner.episode_end().reason;
  NoteLearner(learner, modules.environment, episode);
  for (const UniversalTask* shadow : modules.tasks.shadows) {
    if (shadow->has_ended()) episode.shadows.push_back(EvaluationOf(*shadow));
  }
  return episode;
}

void NoteLearner(const Learner& learner, const Environment& environment, EpisodeRecord& episode) {
  episode.active.faults += learner.passed_over_count();
  episode.learner.clear();
  for (const LearnerCurve& curve : learner.curves()) {
    episode.learner.push_back({curve.name, *curve.value});
  }
  for (const DrawnValue& drawn : environment.drawn()) {
    episode.learner.push_back({drawn.name, drawn.value});
  }
}

EpisodeRecord RunEpisode(int64_t number, const EpisodeModules& modules, const AfterStep& after_step,
                         const NoteStart& note_start) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const double cpu_start = ThreadSeconds();
  int64_t steps = 0;
  StartEpisode(number, modules, note_start);
  after_step(steps);
  while (!modules.learner.episode_over()) {
    modules.environment.RunTimeStep();
    after_step(++steps);
  }
  EpisodeRecord episode = RecordOfEpisode(number, steps, modules);
  episode.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  episode.cpu_seconds = ThreadSeconds() - cpu_start;
  return episode;
}

}  // namespace runtime
