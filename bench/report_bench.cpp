// What it costs to save an episode, to draw one, and to write the reports of one run and of many.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/behavior/motion.h"
#include "runtime/picture/snapshot_strip.h"
#include "runtime/report/report.h"
#include "runtime/run/body_json.h"
#include "runtime/run/run_database.h"
#include "runtime/study/study_report.h"
#include "tests/runtime/report/sample_run.h"
#include "tests/runtime/run/sample_run.h"
#include "tests/runtime/run/temporary_folder.h"
#include "tests/runtime/study/sample_study.h"

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
BENCHMARK(ReportOfFifteenRuns)->Unit(benchmark::kMillisecond);

// Eight pictures of a crawl, so many pixels high.
void DrawAStrip(benchmark::State& state) {
  const std::vector<robot::Link> links = ParseBody(SampleRunRecord().body);
  const Motion motion = ReadMotion(SampleRecording(20, 0.1), static_cast<int>(links.size()));
  const StripOptions options{.height = static_cast<int>(state.range(0))};
  size_t size = 0;
  for (auto _ : state) size = SnapshotStrip(motion, links, options).size();
  state.counters["bytes"] = static_cast<double>(size);
}
BENCHMARK(DrawAStrip)->Arg(208)->Arg(260)->Unit(benchmark::kMillisecond);

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
