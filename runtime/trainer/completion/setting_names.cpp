#include "runtime/trainer/completion/setting_names.h"

#include <algorithm>
#include <filesystem>

#include "base/command_line/completed_value.h"
#include "runtime/trainer/setup/apart.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {
namespace {

bool IsTask(const std::filesystem::path& word) {
  return (word.extension() == ".task" || word.extension() == ".so") &&
         std::filesystem::exists(word);
}

// Without its settings: the last one is not finished.
TaskOptions OptionsOf(const std::string& task, const Words& line) {
  TaskOptions options;
  options.task = task;
  options.agent = command_line::ValueOf("--agent", line);
  options.robot = command_line::ValueOf("--robot", line);
  options.robots = command_line::ValueOf("--robots", line);
  options.environment_socket = command_line::ValueOf("--environment-socket", line);
  return options;
}

Words NamesIn(const TaskSetup& setup) {
  Words names;
  for (const auto& module : setup.graph.modules()) {
    for (const Parameter& parameter : module->parameters()) {
      names.push_back(module->name() + "." + parameter.name + "=");
    }
  }
  return names;
}

}  // namespace

Words SettingNames(const Words& line) {
  const auto task = std::ranges::find_if(line, IsTask);
  if (task == line.end()) return {};
  const TaskOptions options = OptionsOf(*task, line);
  const BuiltTask built(options);
  if (!built.plugin()) return {};
  return RunApart(*task, [&] { return NamesIn(SetUpInSandbox(options, *built.plugin(), 0)); });
}

}  // namespace runtime
