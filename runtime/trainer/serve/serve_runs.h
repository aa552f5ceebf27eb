#pragma once

#include <cstdint>
#include <filesystem>

#include "runtime/trainer/runs/run_session.h"

namespace runtime {

// Serves the folder of many runs (docs/live.md, "Many runs") until it is stopped; returns the exit
// status. Of the options those count that all runs have in common: port, jobs, output. `robots`: as
// for a task. Throws UserError.
int ServeRuns(const std::filesystem::path& folder, const std::filesystem::path& robots,
              const SessionOptions& options);

}  // namespace runtime
