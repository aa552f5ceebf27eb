// What the changes of a run made of its tasks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// Two tasks, by TaskRecord::id.
struct TaskReplacement {
  int64_t before = 0;
  int64_t after = 0;

  bool operator==(const TaskReplacement&) const = default;
};

// For each of the changes, which are all of the run in their order: the task that it brings, and
// the one whose place that takes. A shadow is compared with the active task. Nothing where no task
// comes, and where the change was put in quarantine.
std::vector<std::optional<TaskReplacement>> TaskReplacements(
    const RunRecord& run, const std::vector<ChangeRecord>& changes);

// For each of the changes what the two differ in, as VersionDifference() says it.
std::vector<std::string> ChangeDifferences(const RunRecord& run,
                                           const std::vector<ChangeRecord>& changes);

}  // namespace runtime
