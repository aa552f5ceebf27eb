#include "runtime/training/run/run_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace runtime {

std::string_view RunStateName(RunState state) {
  switch (state) {
    case RunState::kRunning:
      return "running";
    case RunState::kInterrupted:
      return "interrupted";
    case RunState::kFinished:
      return "finished";
  }
  std::abort();
}

const TaskRecord& TaskWithId(const RunRecord& run, int64_t id) {
  return run.tasks.at(static_cast<size_t>(id - 1));
}

std::string VersionText(const TaskRecord& task) {
  return fmt::format("{} ({:.8})", task.task, task.task_hash);
}

bool IsSameVersion(const TaskRecord& a, const TaskRecord& b) {
  if (a.plugin == b.plugin) return true;
  // A plugin that was written by hand may have no hash.
  return !a.task_hash.empty() && a.task_hash == b.task_hash && a.task == b.task &&
         a.compiler == b.compiler;
}

Evaluation* FindEvaluation(EpisodeRecord& episode, int64_t task) {
  if (episode.active.task == task) return &episode.active;
  const auto shadow = std::ranges::find(episode.shadows, task, &Evaluation::task);
  return shadow == episode.shadows.end() ? nullptr : &*shadow;
}

}  // namespace runtime
