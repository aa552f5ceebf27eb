#include "tests/runtime/analysis/study/sample_preferences.h"

#include <numeric>
#include <optional>

#include "base/seal/sha256.h"
#include "runtime/training/run/run_database.h"
#include "tests/runtime/analysis/report/sample_run.h"

namespace runtime {
namespace {

constexpr int64_t kPlanned = 20;

RunRecord RecordOf(const SampleEnding& ending) {
  RunRecord run = SampleRunRecord();
  run.agent = "[modules.task]\ntype = \"UniversalTask\"\n" + ending.params;
  run.seed = ending.seed;
  run.episodes_planned = kPlanned;
  TaskRecord& task = run.tasks.front();
  task.module = "task";
  task.task_file = SOURCE_DIR "/tasks/crawling.task";
  task.sources.resize(1);
  task.sources.front().file = task.task_file;
  task.task_hash = seal::Sha256(task.sources.front().text);
  task.terms = {{"forward", ""}, {"turning", ""}, {"effort", ""}, {"fall", ""}};
  task.metrics = {{"distance", "m", "last", ""}};
  task.logs.clear();
  return run;
}

EpisodeRecord Episode(int64_t number, const SampleEnding& ending) {
  EpisodeRecord episode;
  episode.number = number;
  episode.simulated_seconds = 20;
  episode.cpu_seconds = 1;
  episode.active.task = 1;
  episode.active.end_kind = "truncated";
  episode.active.end_reason = "time is up";
  episode.active.terms = ending.terms;
  if (number <= kPlanned / 2) {
    for (double& sum : episode.active.terms) sum *= 0.5;
  }
  episode.active.episode_return =
      std::accumulate(episode.active.terms.begin(), episode.active.terms.end(), 0.);
  episode.active.metrics = {20 * ending.speed};
  return episode;
}

}  // namespace

void WriteEnding(const std::filesystem::path& folder, const SampleEnding& ending) {
  RunDatabase database = RunDatabase::Create(folder, RecordOf(ending));
  for (int64_t number = 1; number <= ending.episodes; ++number) {
    std::optional<Recording> recording;
    if (number == ending.episodes) recording = SampleRecording(4, ending.speed);
    database.AddEpisode(Episode(number, ending), recording, std::nullopt);
  }
  const bool is_finished = ending.episodes >= kPlanned;
  database.SetState(is_finished ? RunState::kFinished : RunState::kInterrupted);
}

std::vector<std::filesystem::path> WriteThreeEndings(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> runs;
  for (const SampleEnding& ending :
       {SampleEnding{.seed = 1, .terms = {100, -10, 0, -8}},
        SampleEnding{.seed = 2, .terms = {90, -2, 0, 0}, .speed = 0.5},
        SampleEnding{.seed = 3, .terms = {120, -5, 0, -40}, .speed = 1}}) {
    runs.push_back(folder / "crawling" / ("seed" + std::to_string(ending.seed)));
    WriteEnding(runs.back(), ending);
  }
  return runs;
}

TaskParams CrawlingParams() {
  return ParseTaskParams(R"({"hash": "", "params": [
      {"name": "fall_penalty", "unit": "", "default": 4.0, "least": 0.0, "greatest": 20.0,
       "scales": ["fall"], "changes_course": true},
      {"name": "turning_cost", "unit": "", "default": 0.025, "least": 0.0, "greatest": 1.0,
       "scales": ["turning"], "changes_course": true}]})");
}

}  // namespace runtime
