// The recorded episodes of a run, for commands that show one. All throw UserError.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/training/run/run_database.h"

namespace runtime {

// The links of the run's robot, at least one.
std::vector<robot::Link> ReadBody(const std::filesystem::path& folder, const RunRecord& run);

// `wanted`, which must be recorded; if it is 0, the last that is.
int64_t ChooseRecordedEpisode(const std::filesystem::path& folder, const RunDatabase& database,
                              int64_t wanted);

Motion ReadRecordedMotion(const std::filesystem::path& folder, const RunDatabase& database,
                          int64_t episode, size_t link_count);

}  // namespace runtime
