#include "runtime/client/task_files.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/control/build_task.h"

namespace runtime {
namespace {

// As one word of a shell.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char byte : text) quoted += byte == '\'' ? R"('\'')" : std::string(1, byte);
  return quoted + "'";
}

// What a shell's command prints.
std::string OutputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "re"), pclose);
  std::string output;
  if (!pipe) return output;
  std::array<char, 4096> bytes;
  for (size_t size; (size = fread(bytes.data(), 1, bytes.size(), pipe.get())) > 0;) {
    output.append(bytes.data(), size);
  }
  return output;
}

nlohmann::json CompilersReport(const std::filesystem::path& task) {
  const std::string command =
      fmt::format("{} check --format json {} 2>/dev/null", Quoted(CompilerProgram().string()),
                  Quoted(task.string()));
  return nlohmann::json::parse(OutputOf(command), nullptr, false);
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
