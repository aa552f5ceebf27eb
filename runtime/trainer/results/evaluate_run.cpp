#include "runtime/trainer/results/evaluate_run.h"

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "runtime/analysis/study/learning.h"
#include "runtime/trainer/results/learned_run.h"
#include "runtime/training/run/checkpoint.h"
#include "runtime/training/run/return_statistics.h"

namespace runtime {
namespace {

// Fewer than planned where a stop was requested.
std::vector<EpisodeRecord> RunEpisodes(Performer& performer, int64_t count, Progress& progress,
                                       const StopRequest& stop) {
  std::vector<EpisodeRecord> episodes;
  ReturnStatistics statistics;
  bool stop_is_noted = false;
  const auto note_stop = [&](int64_t) {
    if (stop.signal() == 0 || std::exchange(stop_is_noted, true)) return;
    progress.Warn(fmt::format("{} ... Ctrl-C again to stop at once", kStopNotice));
  };
  for (int64_t number = 1; number <= count && stop.signal() == 0; ++number) {
    episodes.push_back(performer.RunEpisode(number, note_stop));
    statistics.Add(episodes.back());
    progress.FinishEpisode(episodes.back(), statistics);
  }
  return episodes;
}

PolicyEvaluation Summary(const LearnedRun& run, const std::string& profile,
                         const std::vector<EpisodeRecord>& episodes) {
  const FinalMeans learned =
      MeansAtTheEnd(run.record, run.episodes, MeanWindow(run.record.episodes_planned));
  const FinalMeans means =
      MeansAtTheEnd(run.record, episodes, static_cast<int64_t>(episodes.size()));
  PolicyEvaluation evaluation{.profile = profile,
                              .learned_profile = run.record.profile,
                              .version = TASKC_VERSION,
                              .checkpoint_episode = run.checkpoint.episode,
                              .checkpoint = StateHash(run.checkpoint.state),
                              .mean_return = means.episode_return,
                              .learned_return = learned.episode_return,
                              .metrics = means.metrics,
                              .learned_metrics = learned.metrics};
  for (const EpisodeRecord& episode : episodes) {
    evaluation.returns.push_back(episode.active.episode_return);
    ++evaluation.ends[episode.active.end_kind];
  }
  return evaluation;
}

}  // namespace

bool HasCheckpoint(const std::filesystem::path& run) {
  return RunDatabase::OpenToRead(run).ReadCheckpoint().has_value();
}

std::optional<PolicyEvaluation> FindEvaluation(const std::filesystem::path& run,
                                               const EvaluationPlan& plan) {
  const std::optional<Checkpoint> checkpoint = RunDatabase::OpenToRead(run).ReadCheckpoint();
  const std::filesystem::path file = EvaluationFile(run, plan.profile);
  if (!checkpoint || !std::filesystem::exists(file)) return std::nullopt;
  try {
    PolicyEvaluation known = ReadEvaluation(file);
    const bool is_wanted = known.version == TASKC_VERSION &&
                           known.checkpoint == StateHash(checkpoint->state) &&
                           static_cast<int64_t>(known.returns.size()) == plan.episodes;
    if (is_wanted) return known;
  } catch (const UserError&) {
    // A damaged file is as good as none: it will be replaced.
  }
  return std::nullopt;
}

std::optional<PolicyEvaluation> EvaluateRun(const std::filesystem::path& folder,
                                            const EvaluationPlan& plan, ProgressStyle style,
                                            const StopRequest& stop, const ModuleTypes& types) {
  auto database = std::make_unique<RunDatabase>(RunDatabase::OpenToRead(folder));
  LearnedRun run(folder, *database, "to evaluate");
  RunRecord planned = run.record;
  planned.episodes_planned = plan.episodes;
  Progress progress(style, planned, stdout, stderr);
  const auto in = [](const std::string& profile) {
    return profile.empty() ? "" : " in " + profile;
  };
  progress.Note(fmt::format("{}: what {} learned{}, up to episode {}, acts{} without learning",
                            folder.string(), run.record.tasks.front().task, in(run.record.profile),
                            run.checkpoint.episode, in(plan.profile)));
  Performer performer(folder, run, *database, plan.profile, progress, stop, types);
  database.reset();  // a run that is being trained is left alone as soon as possible
  const std::vector<EpisodeRecord> episodes = RunEpisodes(performer, plan.episodes, progress, stop);
  if (static_cast<int64_t>(episodes.size()) < plan.episodes) return std::nullopt;
  PolicyEvaluation evaluation = Summary(run, plan.profile, episodes);
  WriteEvaluation(folder, evaluation);
  return evaluation;
}

}  // namespace runtime
