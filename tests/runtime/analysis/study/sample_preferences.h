// Made-up runs of `crawling` that end in what a test says, for preferences between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/analysis/preference/task_params.h"

namespace runtime {

struct SampleEnding {
  uint64_t seed = 1;
  std::vector<double> terms;  // sums of forward, turning, effort and fall in the last ten episodes
  double speed = 0.1;         // of the recorded crawl [m/s]
  int64_t episodes = 20;      // of 20
  std::string params = "fall_penalty = 4.0\nturning_cost = 0.025\n";
};

// A run whose first ten episodes paid half of that. It holds the text of tasks/crawling.task.
void WriteEnding(const std::filesystem::path& folder, const SampleEnding& ending);

// FOLDER/crawling/seed1 to seed3. Their returns at the end are 82 (100 - 10 - 8), 88 (90 - 2) and
// 75 (120 - 5 - 40). Returns their folders.
std::vector<std::filesystem::path> WriteThreeEndings(const std::filesystem::path& folder);

// Those of tasks/crawling.task, which taskc would tell.
TaskParams CrawlingParams();

}  // namespace runtime
