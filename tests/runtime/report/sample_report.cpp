// sample_report FOLDER: two runs with made-up contents and their reports, for looking at the page:
// FOLDER/full with recordings, FOLDER/first with one episode and none.

#include <cstdio>
#include <exception>

#include "runtime/report/report.h"
#include "tests/runtime/report/sample_run.h"

namespace {

void WriteSample(const std::filesystem::path& folder, const runtime::SampleSize& size) {
  std::filesystem::remove_all(folder);
  runtime::WriteSampleRun(folder, size);
  std::printf("%s\n", runtime::WriteReport(folder).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sample_report FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    WriteSample(folder / "full", {.episodes = 800, .record_every = 100, .duration = 20});
    WriteSample(folder / "first", {.episodes = 1});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
