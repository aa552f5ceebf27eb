// Which episodes ran under which task.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// Episodes in a row, both ends included, with the same active task.
struct TaskSpan {
  int64_t task = 0;  // TaskRecord::id
  int64_t first = 0;
  int64_t last = 0;
};

std::vector<TaskSpan> ActiveTasks(std::span<const EpisodeRecord> episodes);

}  // namespace runtime
