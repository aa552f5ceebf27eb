// What became of a run's tasks while it learned: the part of the report's data about it.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// Adds to `data`
//   tasks     all that were loaded, by their ids: [{module, name, file, hash, sources}]
//   versions  which episodes ran under which of them: [{task, first, last}], `task` an index
//   shadows   one curve for each module that had a shadow: [{module, tasks, values}], with a
//   return,
//             in base64, for each episode, which is not a number where it had none
//   changes   in the order in which they took effect: [{episode, step, at, kind, text}], with
//             `difference` where another task came (change_differences.h)
void AddChanges(const RunRecord& run, const std::vector<EpisodeRecord>& episodes,
                const std::vector<ChangeRecord>& changes, nlohmann::json& data);

}  // namespace runtime
