#include "runtime/trainer/results/version_difference.h"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "runtime/base/build_task.h"
#include "runtime/base/child_process.h"
#include "runtime/base/scratch_folder.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

void Write(const fs::path& file, const std::string& text) {
  std::error_code ignored;  // then there is no file, which the compiler would say
  fs::create_directories(file.parent_path(), ignored);
  std::ofstream(file, std::ios::binary) << text;
}

// The texts of a task below `folder`, as they were to each other; gives the place of the first.
fs::path WriteSources(const TaskRecord& task, const fs::path& folder) {
  fs::path first;
  for (const SourceRecord& source : task.sources) {
    const fs::path place = folder / fs::absolute(source.file).lexically_normal().relative_path();
    Write(place, source.text);
    if (first.empty()) first = place;
  }
  return first;
}

}  // namespace

std::string VersionDifference(const RunRecord& run, const TaskRecord& before,
                              const TaskRecord& after) {
  if (before.sources.empty() || after.sources.empty()) return "";
  const ScratchFolder scratch;
  const fs::path robots = scratch.path() / "robots";
  Write(robots / run.robot / "robot.toml", run.robot_description);
  return RunChild(
             {CompilerProgram().string(), "diff",
              WriteSources(before, scratch.path() / "before").string(),
              WriteSources(after, scratch.path() / "after").string(), "--robots", robots.string()},
             Captured::kOutputOnly)
      .captured;
}

}  // namespace runtime
