#include "tests/runtime/analysis/study/sample_study.h"

#include <cmath>
#include <fstream>
#include <optional>

#include "runtime/training/run/policy_evaluation.h"
#include "runtime/training/run/run_database.h"
#include "tests/runtime/analysis/report/sample_run.h"

namespace runtime {
namespace {

EpisodeRecord Episode(int64_t number, const SampleStudyRun& sample) {
  const double progress = 1 - std::exp(-0.1 * static_cast<double>(number));
  const double wobble =
      3 * std::sin(static_cast<double>(number) + static_cast<double>(sample.seed));
  EpisodeRecord episode;
  episode.number = number;
  episode.simulated_seconds = 20;
  episode.wall_seconds = 2;
  episode.cpu_seconds = 1.5;
  episode.active.task = 1;
  episode.active.terms = {1100 * sample.speed * progress + wobble, -100 * sample.speed * progress,
                          0};
  episode.active.episode_return = episode.active.terms[0] + episode.active.terms[1];
  episode.active.end_kind = "truncated";
  episode.active.end_reason = "time is up";
  episode.active.metrics = {20 * sample.speed * progress, 2};
  episode.active.logs = {sample.speed};
  return episode;
}

}  // namespace

void WriteStudyRun(const std::filesystem::path& folder, const SampleStudyRun& sample) {
  RunRecord run = SampleRunRecord();
  run.seed = sample.seed;
  run.episodes_planned = sample.planned;
  RunDatabase database = RunDatabase::Create(folder, run);
  for (int64_t number = 1; number <= sample.episodes; ++number) {
    std::optional<Recording> recording;
    if (number == sample.episodes && sample.is_recorded) {
      recording = SampleRecording(4 + 0.2 * static_cast<double>(sample.seed), sample.speed);
      recording->is_best = sample.is_best;
    }
    database.AddEpisode(Episode(number, sample), recording, std::nullopt);
  }
  const bool is_finished = sample.episodes >= sample.planned;
  database.SetState(is_finished ? RunState::kFinished : RunState::kInterrupted);
}

void WriteSampleEvaluation(const std::filesystem::path& run, const std::string& profile,
                           const SampleStudyRun& sample, double share) {
  PolicyEvaluation evaluation;
  evaluation.profile = profile;
  evaluation.learned_profile = "paper";
  evaluation.checkpoint_episode = sample.episodes;
  evaluation.learned_return = 1000 * sample.speed;
  evaluation.mean_return = share * evaluation.learned_return;
  evaluation.returns = {evaluation.mean_return};
  WriteEvaluation(run, evaluation);
}

std::vector<std::filesystem::path> WriteStudy(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> runs;
  const auto write = [&](const SampleStudyRun& sample) {
    runs.push_back(folder / "crawling" / ("seed" + std::to_string(sample.seed)));
    WriteStudyRun(runs.back(), sample);
    if (sample.episodes < sample.planned) return;
    WriteSampleEvaluation(runs.back(), "fast", sample, 0.9);
    WriteSampleEvaluation(runs.back(), "paper-tree", sample,
                          1.03 - 0.01 * static_cast<double>(sample.seed));
  };
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    write({.seed = seed, .speed = 0.1 + 0.002 * static_cast<double>(seed)});
  }
  for (uint64_t seed = 6; seed <= 7; ++seed) write({.seed = seed, .speed = 0.5});
  write({.seed = 8, .episodes = 25});
  runs.push_back(folder / "careful" / "seed1");
  WriteStudyRun(runs.back(), {.speed = 0.2, .is_recorded = false});
  std::ofstream(folder / "groups.toml") << "\"crawling/seed6\" = \"Crawls fast.\"\n";
  return runs;
}

}  // namespace runtime
