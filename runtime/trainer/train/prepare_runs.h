// The runs of one task and agent that differ in their seeds, in their folders.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// Makes those runs in `folder` that are not there yet, and returns the folders of all. One that is
// there already is taken over as it is; only its number of episodes can grow. Throws UserError
// where it is of another task or agent: `place` says where these are from, `remedy` what to do.
std::vector<std::filesystem::path> PrepareRuns(const TaskSetup& setup, const RunRecord& run,
                                               const std::vector<uint64_t>& seeds,
                                               const std::filesystem::path& folder,
                                               const std::string& place, const std::string& remedy);

}  // namespace runtime
