#include "runtime/control/build_task.h"

#include <fmt/format.h>

#include "runtime/control/child_process.h"
#include "runtime/module/user_error.h"

namespace runtime {
namespace {

ChildResult RunTaskc(std::vector<std::string> words, Captured captured) {
  const std::string compiler = CompilerProgram().string();
  words.insert(words.begin(), compiler);
  ChildResult result = RunChild(std::move(words), captured);
  if (!result.error) return result;
  throw UserError(fmt::format(
      "{}: cannot run the compiler: {}; install taskc beside the trainer, or give a plugin that "
      "is built already",
      compiler, result.error.message()));
}

}  // namespace

std::filesystem::path CompilerProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "taskc";
}

bool RunCompiler(const std::vector<std::string>& words, std::string& output) {
  ChildResult result = RunTaskc(words, Captured::kOutput);
  output = std::move(result.captured);
  return result.is_success;
}

bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin,
               std::string* messages) {
  const Captured captured = messages != nullptr ? Captured::kMessages : Captured::kNothing;
  ChildResult result = RunTaskc({"build", task.string(), "-o", plugin.string()}, captured);
  if (messages != nullptr) *messages = std::move(result.captured);
  return result.is_success;
}

}  // namespace runtime
