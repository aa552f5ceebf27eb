#include "runtime/base/build_task.h"

#include <fmt/format.h>

#include "runtime/base/child_process.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

ChildResult RunTaskc(std::vector<std::string> words, Captured captured,
                     const std::stop_token& stop = {}) {
  const std::string compiler = CompilerProgram().string();
  words.insert(words.begin(), compiler);
  const ChildLimits limits{.stop = stop};
  ChildResult result = RunChild(std::move(words), captured, limits);
  if (result.was_too_slow) {
    throw UserError(fmt::format(
        "{}: the compiler did not finish within {} s and was killed; try `taskc build` by itself, "
        "and "
        "give the plugin that it makes",
        compiler, std::chrono::duration_cast<std::chrono::seconds>(limits.patience).count()));
  }
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

bool BuildTask(const TaskBuild& build, std::string* messages, const std::stop_token& stop) {
  const Captured captured = messages != nullptr ? Captured::kMessages : Captured::kNothing;
  std::vector<std::string> words = {"build", build.task.string(), "-o", build.plugin.string()};
  if (!build.robots.empty()) words.insert(words.end(), {"--robots", build.robots.string()});
  if (!build.text.empty()) words.insert(words.end(), {"--text", build.text.string()});
  ChildResult result = RunTaskc(std::move(words), captured, stop);
  if (messages != nullptr) *messages = std::move(result.captured);
  return result.is_success;
}

}  // namespace runtime
