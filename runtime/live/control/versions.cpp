#include "runtime/live/control/versions.h"

#include <fmt/format.h>

#include <vector>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

std::vector<const TaskRecord*> VersionsOf(const RunRecord& run, const std::string& module) {
  std::vector<const TaskRecord*> versions;
  for (const TaskRecord& task : run.tasks) {
    if (task.module == module) versions.push_back(&task);
  }
  return versions;
}

}  // namespace

const TaskRecord& FindVersion(const RunRecord& run, const std::string& module,
                              const std::string& version) {
  const std::vector<const TaskRecord*> versions = VersionsOf(run, module);
  std::vector<const TaskRecord*> found;
  std::string list;
  for (const TaskRecord* task : versions) {
    if (std::to_string(task->id) == version) return *task;
    if (!version.empty() && task->task_hash.starts_with(version)) found.push_back(task);
    list += fmt::format("{}{} = {}", list.empty() ? "" : ", ", task->id, VersionText(*task));
  }
  if (found.size() == 1) return *found.front();
  throw UserError(fmt::format("`{}` {} `{}`: it has had {}", module,
                              found.empty() ? "has had no version" : "has had several versions",
                              version, list));
}

nlohmann::json VersionsJson(const RunRecord& run, const std::string& module) {
  nlohmann::json json = nlohmann::json::array();
  for (const TaskRecord* task : VersionsOf(run, module)) {
    json.push_back({{"number", task->id},
                    {"task", task->task},
                    {"hash", task->task_hash},
                    {"file", task->task_file}});
  }
  return json;
}

}  // namespace runtime
