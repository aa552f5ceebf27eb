// A task with other weights than the one it extends.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

struct ParamOverride {
  std::string name;
  std::string value;  // as the task language writes it, with its unit
  std::string note;   // "was 4"
};

struct PreferredTask {
  std::filesystem::path file;  // .task; its stem is the task's name
  std::filesystem::path base;  // the task that it extends
  std::string description;     // one line: from which preferences the values are
  std::vector<ParamOverride> overrides;
};

// Writes it and, where the base has an agent of its own beside it, one that includes that: a task
// does not inherit it. What taskc refuses is not written; an old file is replaced only where
// `is_forced`. Returns the files written. Throws UserError.
std::vector<std::filesystem::path> WritePreferredTask(const PreferredTask& task, bool is_forced);

}  // namespace runtime
