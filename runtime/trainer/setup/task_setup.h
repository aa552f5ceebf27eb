// From a task's file and what the user says about it to a graph that is ready to start.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/command_line/command.h"
#include "plugins/robot/robot_description.h"
#include "runtime/base/landlock.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/core/agent/agent.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/plugin.h"
#include "runtime/trainer/setup/plugin_facts.h"
#include "runtime/training/run/module_types.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {

// --profile
command_line::Option AddProfileOption(command_line::Command& command, std::string& profile);
// --robots
void AddRobotsOption(command_line::Command& command, std::filesystem::path& robots);

struct TaskOptions {
  std::filesystem::path task;  // .task or .so
  std::string profile;
  std::string agent;  // a name or a file (FindAgentFile)
  std::string robot;
  std::filesystem::path robots{};  // where to look for robots first; may be empty
  std::vector<std::string> settings;
  std::string environment_socket{};  // at which another program is the environment; may be empty

  void AddTo(command_line::Command& command);
};

// The plugin of a task, built for as long as this object lives if it is not a plugin already.
class BuiltTask {
 public:
  // Throws CallError where there is no such task, UserError where it cannot be built.
  explicit BuiltTask(const TaskOptions& options);

  // Nothing where the task has errors: the compiler has said which.
  const std::optional<std::filesystem::path>& plugin() const { return plugin_; }

  // What a sandbox has to let this object do in which it ends.
  void AddTo(FileRules& rules) const {
    if (scratch_) rules.writable.push_back(scratch_->path());
  }

 private:
  std::optional<ScratchFolder> scratch_;
  std::optional<std::filesystem::path> plugin_;
};

struct TaskSetup;
// Called when all files are known that a task and its agent need, and none of their code has run in
// this process: of the setup there is what comes before `plugin`.
using BeforeLoading = std::function<void(const TaskSetup&)>;

struct TaskSetup {
  // `program_types`: what the agent's modules can be made of, besides its own composites. Throws
  // UserError or CallError for whatever does not exist or does not fit.
  TaskSetup(const TaskOptions& wanted, const std::filesystem::path& plugin_file, uint64_t seed,
            const ModuleTypes& program_types = ProgramModuleTypes(),
            const BeforeLoading& before_loading = {});
  TaskSetup(const TaskSetup&) = delete;
  TaskSetup& operator=(const TaskSetup&) = delete;

  TaskOptions options;
  std::filesystem::path plugin_file;
  PluginFacts facts;
  std::filesystem::path robot_file;  // "": a task without a robot
  robot::RobotDescription robot;     // of such a task: empty (context.h)
  Agent agent;                       // resolved
  Agent changes;                     // of it, by the user
  std::shared_ptr<const Plugin> plugin;
  std::vector<Setting> settings;  // what the user has set in the agent
  Context context;
  ModuleTypes types;  // also those of the agent's libraries, and its own composites
  ModuleGraph graph;
};

}  // namespace runtime
