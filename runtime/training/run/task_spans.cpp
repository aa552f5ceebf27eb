#include "runtime/training/run/task_spans.h"

namespace runtime {

std::vector<TaskSpan> ActiveTasks(std::span<const EpisodeRecord> episodes) {
  std::vector<TaskSpan> spans;
  for (const EpisodeRecord& episode : episodes) {
    const int64_t task = episode.active.task;
    if (spans.empty() || spans.back().task != task) spans.push_back({task, episode.number, 0});
    spans.back().last = episode.number;
  }
  return spans;
}

}  // namespace runtime
