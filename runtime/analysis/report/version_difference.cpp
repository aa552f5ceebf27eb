#include "runtime/analysis/report/version_difference.h"

#include <map>
#include <mutex>

#include "runtime/base/build_task.h"
#include "runtime/base/child_process.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/training/run/recorded_sources.h"

namespace runtime {
namespace {

std::string Compare(const RunRecord& run, const TaskRecord& before, const TaskRecord& after) {
  const ScratchFolder scratch;
  const auto robots = WriteRobot(run, scratch.path() / "robots");
  const auto old_task = WriteSources(before.sources, scratch.path() / "before").task;
  const auto new_task = WriteSources(after.sources, scratch.path() / "after").task;
  return RunChild({CompilerProgram().string(), "diff", old_task.string(), new_task.string(),
                   "--robots", robots.string()},
                  Captured::kOutputOnly)
      .captured;
}

// A page that follows a run asks again and again.
class Known {
 public:
  template <class Find>
  std::string Get(const std::string& key, Find find) {
    const std::lock_guard lock(mutex_);
    const auto [known, is_new] = differences_.try_emplace(key);
    if (is_new) known->second = find();
    return known->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> differences_;
};

}  // namespace

std::string VersionDifference(const RunRecord& run, const TaskRecord& before,
                              const TaskRecord& after) {
  if (before.sources.empty() || after.sources.empty()) return "";
  if (before.task_hash == after.task_hash) return "";
  static Known known;
  return known.Get(before.task_hash + after.task_hash + run.robot_description,
                   [&] { return Compare(run, before, after); });
}

}  // namespace runtime
