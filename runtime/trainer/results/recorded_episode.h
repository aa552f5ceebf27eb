// The recorded episodes of a run, for commands that show one. All throw UserError.
#pragma once

#include <cstdint>
#include <filesystem>

#include "runtime/analysis/behavior/motion.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/run_database.h"

namespace runtime {

// What the run's recordings show: at least one link.
RecordedBody ReadBody(const std::filesystem::path& folder, const RunRecord& run);

// `wanted`, which must be recorded; if it is 0, the last that is.
int64_t ChooseRecordedEpisode(const std::filesystem::path& folder, const RunDatabase& database,
                              int64_t wanted);

// Throws CallError for a part of the motion, in seconds, that is none.
void CheckSpan(double from, double to, const Motion& motion);

Motion ReadRecordedMotion(const std::filesystem::path& folder, const RunDatabase& database,
                          int64_t episode, size_t part_count);

}  // namespace runtime
