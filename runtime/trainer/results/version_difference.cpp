#include "runtime/trainer/results/version_difference.h"

#include "runtime/base/build_task.h"
#include "runtime/base/child_process.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/training/run/recorded_sources.h"

namespace runtime {

std::string VersionDifference(const RunRecord& run, const TaskRecord& before,
                              const TaskRecord& after) {
  if (before.sources.empty() || after.sources.empty()) return "";
  const ScratchFolder scratch;
  const auto robots = WriteRobot(run, scratch.path() / "robots");
  const auto old_task = WriteSources(before.sources, scratch.path() / "before").task;
  const auto new_task = WriteSources(after.sources, scratch.path() / "after").task;
  return RunChild({CompilerProgram().string(), "diff", old_task.string(), new_task.string(),
                   "--robots", robots.string()},
                  Captured::kOutputOnly)
      .captured;
}

}  // namespace runtime
