// What it costs to save an episode, and to write the reports of one run and of many.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/report/report.h"
#include "runtime/run/run_database.h"
#include "runtime/study/study_report.h"
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
