// trainer completion bash|zsh|fish
#include <set>
#include <string>
#include <vector>

#include "base/command_line/completion.h"
#include "plugins/robot/robot_description.h"
#include "plugins/robot/robot_names.h"
#include "runtime/live/client/find_trainer.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/setup/agent_presets.h"

namespace runtime {
namespace {

using Names = std::vector<std::string>;

Names Robots() { return robot::RobotNames(robot::RobotFolders({"."}, {})); }

// Of all robots: a command line need not say which one it is for.
Names Agents() {
  std::set<std::string> names;
  for (const std::string& robot : Robots()) {
    const auto file = robot::FindRobotFile(robot, robot::RobotFolders({"."}, {}));
    for (const AgentPreset& preset : AgentPresetsOf(file.parent_path())) names.insert(preset.name);
  }
  return {names.begin(), names.end()};
}

Names Trainers() { return TrainersUnder("runs"); }

}  // namespace

void AddCompletionCommand(command_line::Command& program) {
  command_line::Command& command = program.AddCommand(
      "completion", "Prints a script that completes trainer's command line in a shell.");
  const command_line::ValueNames names = {{"AGENT", Agents}, {"ROBOT", Robots}, {"RUN", Trainers}};
  command.OnRun([print = command_line::DeclareCompletion(command, {.words = {}, .names = names})] {
    print();
    return kSuccess;
  });
}

}  // namespace runtime
