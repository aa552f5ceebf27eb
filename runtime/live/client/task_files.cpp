#include "runtime/live/client/task_files.h"

#include <nlohmann/json.hpp>
#include <string>

#include "runtime/base/build_task.h"
#include "runtime/base/child_process.h"

namespace runtime {
namespace {

nlohmann::json CompilersReport(const std::filesystem::path& task) {
  const ChildResult report = RunChild(
      {CompilerProgram().string(), "check", "--json", task.string()}, Captured::kOutputOnly);
  return nlohmann::json::parse(report.captured, nullptr, false);
}

}  // namespace

std::set<std::filesystem::path> FilesOfTask(const std::filesystem::path& task) {
  std::set<std::filesystem::path> files = {task};
  if (task.extension() != ".task") return files;
  const nlohmann::json report = CompilersReport(task);
  if (!report.contains("tasks") || report["tasks"].empty()) return files;
  for (const std::string file : report["tasks"].front()["files"]) files.insert(file);
  return files;
}

}  // namespace runtime
