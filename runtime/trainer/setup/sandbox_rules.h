// What a process may reach that trains a task, or only sets it up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "base/command_line/command.h"
#include "runtime/base/sandbox.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/core/agent/agent.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {

// --no-sandbox, of a command that runs code of tasks.
void AddSandboxOption(command_line::Command& command);

// To read: the plugin, the robot's folder, the agent's libraries, and files that its parameters
// name. To write: the cache of nets. To connect to: the program that is the environment, if the
// agent has such a one.
SandboxRules RulesOf(const TaskSetup& known);

// The same, and to write: `folder`, which exists, the first of those that can be written.
SandboxRules RulesOf(const TaskSetup& known, const std::filesystem::path& folder);

// The same of a run, whose `folder` has all that its agent needs.
SandboxRules RulesOf(const Agent& agent, const std::filesystem::path& folder);

// Sets up the task of a plugin in a sandbox, which this process enters before code of the task or
// of a module runs. To write, beside the rules' own: `folder`, if there is one.
TaskSetup SetUpInSandbox(const TaskOptions& options, const std::filesystem::path& plugin,
                         uint64_t seed,
                         const std::optional<std::filesystem::path>& folder = std::nullopt);

// For a command that does all its work in one process, in the sandbox: with a temporary folder,
// which goes with this object.
class CommandSandbox {
 public:
  explicit CommandSandbox(SandboxRules rules);
  CommandSandbox(const CommandSandbox&) = delete;
  CommandSandbox& operator=(const CommandSandbox&) = delete;

 private:
  ScratchFolder temporary_;
};

}  // namespace runtime
