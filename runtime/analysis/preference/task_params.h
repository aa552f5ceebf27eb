// Which params of a task are weights of which reward terms, as `taskc doc --json` says it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct TaskParam {
  std::string name;
  std::string unit;
  double initial = 0;  // a condition is 1 or 0
  double least = 0;    // -infinity where there is no range
  double greatest = 0;
  std::vector<std::string> scales;  // terms that pay this param times something without it
  bool changes_course = false;      // it also decides when an episode ends
};

struct TaskParams {
  std::string task_hash;
  std::vector<TaskParam> params;
};

// All functions throw UserError.

TaskParams ParseTaskParams(const std::string& text);
// Of the task's sources as the run's record holds them: whatever has become of the files.
TaskParams ReadTaskParams(const TaskRecord& task);
TaskParams ReadTaskParams(const std::filesystem::path& task_file);

}  // namespace runtime
