// trainer completion bash|zsh|fish
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/command_line/completion.h"
#include "plugins/robot/robot_description.h"
#include "plugins/robot/robot_names.h"
#include "runtime/live/client/find_trainer.h"
#include "runtime/live/client/known_names.h"
#include "runtime/live/control/command_table.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/completion/setting_names.h"
#include "runtime/trainer/ctl/arguments.h"
#include "runtime/trainer/ctl/options.h"
#include "runtime/trainer/setup/agent_presets.h"

namespace runtime {
namespace {

using Names = std::vector<std::string>;

Names Robots(const Names& = {}) { return robot::RobotNames(robot::RobotFolders({"."}, {})); }

// Of all robots: a command line need not say which one it is for.
Names Agents(const Names&) {
  std::set<std::string> names;
  for (const std::string& robot : Robots()) {
    const auto file = robot::FindRobotFile(robot, robot::RobotFolders({"."}, {}));
    for (const AgentPreset& preset : AgentPresetsOf(file.parent_path())) names.insert(preset.name);
  }
  return {names.begin(), names.end()};
}

Names Trainers(const Names&) { return TrainersUnder("runs"); }

// What the arguments of `trainer ctl` name, in the run that the line is about.
void AddNamesOfRuns(command_line::ValueNames& lists) {
  for (const CommandSpec& command : Commands()) {
    for (const ArgumentSpec& argument : command.arguments) {
      if (argument.names == NamedPart::kNone) continue;
      lists["ctl " + CtlWords(command) + " " + CtlWord(argument)] =
          [part = argument.names](const Names& line) {
            const std::string run = command_line::ValueOf(CtlOptions::kRun, line);
            return KnownNames(run.empty() ? FindTrainer("runs") : std::filesystem::path(run), part);
          };
    }
  }
}

}  // namespace

void AddCompletionCommand(command_line::Command& program) {
  command_line::Command& command = program.AddCommand(
      "completion", "Prints a script that completes trainer's command line in a shell.");
  command_line::ValueNames names = {
      {"AGENT", Agents}, {"ROBOT", Robots}, {"RUN", Trainers}, {"SETTING", SettingNames}};
  AddNamesOfRuns(names);
  command.OnRun([print = command_line::DeclareCompletion(command, {.words = {}, .names = names})] {
    print();
    return kSuccess;
  });
}

}  // namespace runtime
