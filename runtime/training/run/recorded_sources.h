// A task's texts and its robot as a run's record holds them, as files again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct RecordedSources {
  std::filesystem::path task;  // the file of the task itself
  // All that lead to the other files and not to the task, deepest first: those of libraries among
  // them.
  std::vector<std::filesystem::path> folders;
};

// Writes the sources, of which there is at least one, into `folder`, to each other as they were.
// Throws UserError.
RecordedSources WriteSources(const std::vector<SourceRecord>& sources,
                             const std::filesystem::path& folder);

// Writes the robot of the run, if it has one, into a folder of robots, which is returned.
std::filesystem::path WriteRobot(const RunRecord& run, const std::filesystem::path& robots);

}  // namespace runtime
