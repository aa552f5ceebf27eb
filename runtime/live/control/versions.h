// The tasks that a task module has had in a run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "runtime/training/run/run_records.h"

namespace runtime {

// `version`: its number (TaskRecord::id), or the beginning of its hash. Throws UserError, with a
// list of those there are, where it is none or several.
const TaskRecord& FindVersion(const RunRecord& run, const std::string& module,
                              const std::string& version);

// [{"number", "task", "hash", "file"}], in the order in which they came.
nlohmann::json VersionsJson(const RunRecord& run, const std::string& module);

}  // namespace runtime
