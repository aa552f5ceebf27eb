// sample_reports FOLDER: runs with made-up contents and their reports, for looking at the page:
// FOLDER/full with recordings, FOLDER/first with one episode and none, FOLDER/tuned with changes,
// FOLDER/study, many runs, and FOLDER/probe, searches.

#include <cstdio>
#include <exception>
#include <functional>

#include "runtime/analysis/probe/probe_page.h"
#include "runtime/analysis/report/report.h"
#include "runtime/analysis/study/study_report.h"
#include "tests/runtime/analysis/report/sample_run.h"
#include "tests/runtime/analysis/study/sample_study.h"

namespace {

void WriteReportOf(const std::filesystem::path& folder,
                   const std::function<void(const std::filesystem::path&)>& write_run) {
  std::filesystem::remove_all(folder);
  write_run(folder);
  std::printf("%s\n", runtime::WriteReport(folder).c_str());
}

void WriteSample(const std::filesystem::path& folder, const runtime::SampleSize& size) {
  WriteReportOf(folder, [&](const auto& place) { runtime::WriteSampleRun(place, size); });
}

void WriteStudySample(const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  const auto runs = runtime::WriteStudy(folder);
  std::printf("%s\n", runtime::WriteStudyReport(folder, runs, {}).c_str());
}

// Two searches find the same, one something better, and with one the simulation goes astray.
void WriteProbeSample(const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  std::vector<std::filesystem::path> runs;
  for (const double speed : {0.1, 0.11, 0.5, 13.0}) {
    const uint64_t seed = runs.size() + 1;
    runs.push_back(folder / ("seed" + std::to_string(seed)));
    runtime::WriteStudyRun(runs.back(), {.seed = seed, .speed = speed, .is_best = true});
  }
  const std::filesystem::path page = folder / "probe.html";
  runtime::WriteProbePage(runtime::ReadProbe(folder, runs), page);
  std::printf("%s\n", page.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sample_reports FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    WriteSample(folder / "full", {.episodes = 800, .record_every = 100, .duration = 20});
    WriteSample(folder / "first", {.episodes = 1});
    WriteReportOf(folder / "tuned", runtime::WriteTunedRun);
    WriteStudySample(folder / "study");
    WriteProbeSample(folder / "probe");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
