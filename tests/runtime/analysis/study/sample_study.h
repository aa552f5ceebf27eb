// Folders of many runs with made-up contents.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct SampleStudyRun {
  uint64_t seed = 1;
  double speed = 0.1;  // of the crawl at the end [m/s]
  int64_t episodes = 40;
  int64_t planned = 40;
  bool is_recorded = true;  // its last episode
  bool is_best = false;     // that episode is better than all before it, and so noted
};

// A run of `crawling` in `folder` whose return grows from 0 toward 1000 times its speed.
void WriteStudyRun(const std::filesystem::path& folder, const SampleStudyRun& sample);

// What is left of the return of such a run in another profile.
void WriteSampleEvaluation(const std::filesystem::path& run, const std::string& profile,
                           const SampleStudyRun& sample, double share);

// Eight runs in FOLDER/crawling: 1 to 5 end in a slow crawl, 6 and 7 in a fast one, 8 has not
// ended; the first seven were evaluated in two other profiles. One run in FOLDER/careful: of
// another version of the task. groups.toml describes seed 6. Returns the folders of the runs in
// this order.
std::vector<std::filesystem::path> WriteStudy(const std::filesystem::path& folder);

}  // namespace runtime
