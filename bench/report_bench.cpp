// What it costs to save an episode, to draw one, to write the reports of one run and of many, and
// to fit weights to preferences.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/analysis/report/report.h"
#include "runtime/analysis/study/preference_fit.h"
#include "runtime/analysis/study/study_report.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/run_database.h"
#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/analysis/study/sample_preferences.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

constexpr uint64_t kRuns = 15;
constexpr int64_t kEpisodes = 1500;

// Fifteen finished runs of 1500 episodes, made once.
class ManyRuns {
 public:
  ManyRuns() {
    for (uint64_t seed = 1; seed <= kRuns; ++seed) {
      folders_.push_back(parent_.path() / "crawling" / ("seed" + std::to_string(seed)));
      WriteStudyRun(folders_.back(), {.seed = seed,
                                      .speed = 0.05 * static_cast<double>(seed),
                                      .episodes = kEpisodes,
                                      .planned = kEpisodes});
    }
  }
  const std::filesystem::path& folder() const { return parent_.path(); }
  const std::vector<std::filesystem::path>& runs() const { return folders_; }

 private:
  TemporaryFolder parent_;
  std::vector<std::filesystem::path> folders_;
};

const ManyRuns& Runs() {
  static const ManyRuns runs;
  return runs;
}

void ReportOfARun(benchmark::State& state) {
  const std::filesystem::path& run = Runs().runs().front();
  for (auto _ : state) WriteReport(run);
}
BENCHMARK(ReportOfARun)->Unit(benchmark::kMillisecond);

void ReportOfFifteenRuns(benchmark::State& state) {
  for (auto _ : state) WriteStudyReport(Runs().folder(), Runs().runs(), {});
}
BENCHMARK(ReportOfFifteenRuns)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

// Eight pictures of a crawl, so many pixels high; drawn at the same time, so all threads count.
void DrawAStrip(benchmark::State& state) {
  const std::vector<robot::Link> links = ParseBody(SampleRunRecord().body).value().parts;
  const Motion motion = ReadMotion(SampleRecording(20, 0.1), static_cast<int>(links.size()));
  const StripOptions options{.height = static_cast<int>(state.range(0))};
  size_t size = 0;
  for (auto _ : state) size = SnapshotStrip(motion, links, options).size();
  state.counters["bytes"] = static_cast<double>(size);
}
BENCHMARK(DrawAStrip)->Arg(208)->Arg(260)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

// Ten runs of 4000 episodes, as they are in memory once they were read.
StudyExperiment TenRuns() {
  StudyExperiment experiment{"crawling", {}};
  for (int number = 1; number <= 10; ++number) {
    StudyRun& run = experiment.runs.emplace_back();
    run.name = "crawling/seed" + std::to_string(number);
    run.record = SampleRun();
    run.record.agent = "[modules.task]\nfall_penalty = 4.0\nturning_cost = 0.025\n";
    run.record.episodes_planned = 4000;
    run.record.tasks.front().terms = {{"forward", ""}, {"turning", ""}, {"fall", ""}};
    for (int64_t episode = 1; episode <= run.record.episodes_planned; ++episode) {
      run.episodes.push_back(SampleEpisode(episode));
      run.episodes.back().active.terms = {100. + number * number, -3. * number, -4. * (number % 3)};
      run.episodes.back().active.metrics.clear();
      run.episodes.back().active.logs.clear();
    }
  }
  return experiment;
}

// The fit to nine preferences, and all episodes under the new weights.
void FitPreferencesOfTenRuns(benchmark::State& state) {
  const StudyExperiment experiment = TenRuns();
  ExperimentResult result{&experiment, 50, {}, {}};
  std::vector<Preference> preferences;
  for (const StudyRun& run : experiment.runs) {
    result.runs.emplace_back().run = &run;
    result.runs.back().final = MeansAtTheEnd(run.record, run.episodes, result.window);
    if (&run == &experiment.runs.front()) continue;
    preferences.push_back({ParseBehaviorName("crawling/seed1"), ParseBehaviorName(run.name)});
  }
  const TaskParams params = CrawlingParams();
  for (auto _ : state) benchmark::DoNotOptimize(FitPreferences(result, params, preferences));
}
BENCHMARK(FitPreferencesOfTenRuns)->Unit(benchmark::kMillisecond);

// With two terms, a metric and two logs, and as many shadows as the argument says.
void SaveAnEpisode(benchmark::State& state) {
  const TemporaryFolder folder;
  RunDatabase database = RunDatabase::Create(folder.path() / "run", SampleRun());
  EpisodeRecord episode = SampleEpisode(1);
  for (int64_t i = 0; i < state.range(0); ++i) {
    Evaluation shadow = SampleShadow();
    shadow.task = database.AddTask(SampleVersion());
    episode.shadows.push_back(std::move(shadow));
  }
  for (auto _ : state) {
    database.AddEpisode(episode, {}, {});
    ++episode.number;
  }
}
BENCHMARK(SaveAnEpisode)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace runtime
