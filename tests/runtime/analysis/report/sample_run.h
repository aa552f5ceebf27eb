// Runs with made-up but plausible contents.
#pragma once

#include <filesystem>
#include <string>

#include "runtime/training/run/run_database.h"

namespace runtime {

// The task `crawling` as a run notes it.
TaskRecord SampleCrawling();

// What a run of `crawling` notes about itself; `body` is that of the humanoid.
RunRecord SampleRunRecord();

// A recording of the humanoid crawling for `duration` seconds.
Recording SampleRecording(double duration, double speed);

struct SampleSize {
  int64_t episodes = 1;
  int64_t record_every = 0;  // each of these and each new best one is recorded; 0: none
  double duration = 1;       // of a recording [s]
};

// A finished run in `folder`, whose return grows as learning curves do.
void WriteSampleRun(const std::filesystem::path& folder, const SampleSize& size);

// A run of 400 episodes that was tuned while it learned: a shadow, `careful`, from episode 101 on,
// whose task took the place of the active one before episode 251, two changes of parameters, and an
// evaluation in the profile paper-tree.
void WriteTunedRun(const std::filesystem::path& folder);

}  // namespace runtime
