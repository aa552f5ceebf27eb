// The searches of a probe: runs that are trained side by side.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/training/run/progress.h"
#include "runtime/training/run/stop_request.h"

namespace runtime {

struct ProbeBudget {
  int64_t episodes = 0;  // of each search, with those that it has already; 0: `seconds` count
  double seconds = 90;   // of this call
};

enum class ProbeEnd { kDone, kStopped, kFailed };

// Trains these runs of `folder`, `jobs` at a time. Where episodes count, each gets as many, so that
// what is found depends neither on the machine nor on how many run at a time. Where seconds count,
// as ProbeSchedule says; a probe that has given up searches does not take them up again.
ProbeEnd Search(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& runs,
                const ProbeBudget& budget, int jobs, ProgressStyle style, const StopRequest& stop);

}  // namespace runtime
