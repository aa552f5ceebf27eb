// A run as its record alone makes it again, in a folder of its own: tasks, robot and agent as they
// were, nothing learned.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

enum class Plugins {
  kRebuilt,  // from the texts in the record, by taskc
  kKept,     // those in the run's folder
};

// By what a task was compiled: "taskc 0.1.0, GCC: (Debian 12.2.0-14) 12.2.0".
struct CompilerOfTask {
  int64_t task = 0;  // TaskRecord::id
  std::string recorded;
  std::string here;
};

struct RebuiltRun {
  RunRecord run;  // of the folder; plans as many episodes as the old one
  std::vector<CompilerOfTask> compilers;
};

// Makes in `folder`, which is empty, all that the run in `old_folder` with the record `run` needs
// to be trained again with these changes. Tasks that come with no change but such as were taken
// back are left out. None of their code runs in this process. Throws UserError where the record
// does not have all that it takes.
RebuiltRun Rebuild(const std::filesystem::path& old_folder, const RunRecord& run,
                   const std::vector<ChangeRecord>& changes, Plugins plugins,
                   const std::filesystem::path& folder);

// The changes (ChangeRecord::id) of which the record says that they were taken back, also for their
// tasks.
std::vector<ChangeRecord> TakenBack(const std::vector<ChangeRecord>& changes);

}  // namespace runtime
