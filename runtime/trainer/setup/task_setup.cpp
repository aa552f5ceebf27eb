#include "runtime/trainer/setup/task_setup.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/build_task.h"
#include "runtime/base/suggestion.h"
#include "runtime/core/module/context.h"
#include "runtime/trainer/setup/agent_layers.h"
#include "runtime/training/simulation/profile.h"

namespace runtime {
namespace {

using command_line::CallError;

void CheckTaskFile(const std::filesystem::path& task) {
  if (task.extension() != ".task" && task.extension() != ".so") {
    const std::string meant = task.string() + ".task";
    throw CallError(fmt::format(
        "{}: a task is a .task file, or a .so file that taskc has built from one{}", task.string(),
        std::filesystem::exists(meant) ? fmt::format("; did you mean `{}`?", meant) : ""));
  }
  if (std::filesystem::exists(task)) return;
  std::vector<std::string> neighbors;
  const std::filesystem::path folder = task.has_parent_path() ? task.parent_path() : ".";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == task.extension()) {
      neighbors.push_back(entry.path().filename().string());
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  throw CallError(
      fmt::format("{}: there is no such file{}", task.string(),
                  neighbors.empty() ? "" : Suggestion(task.filename().string(), neighbors)));
}

// Runs without an end would never reach their second episode.
void CheckHasEnd(const taskc_plugin& plugin) {
  if (plugin.end_count > 0) return;
  throw UserError(
      fmt::format("{}: no episode of task `{}` ever ends; add a limit, for example "
                  "`if time > 20 s {{ truncate_episode \"time is up\" }}` in `on end_of_time_step`",
                  plugin.sources[0].file, plugin.name));
}

// "": none.
std::string RobotName(const TaskOptions& options, const PluginFacts& plugin) {
  return options.robot.empty() ? plugin.robot : options.robot;
}

// As the compiler looks for it, which does so beside the file that names it: that may be another
// one than the task's own.
std::vector<std::filesystem::path> RobotFoldersOf(const TaskOptions& options,
                                                  const PluginFacts& plugin) {
  std::vector<std::filesystem::path> files = {options.task};
  files.insert(files.end(), plugin.sources.begin(), plugin.sources.end());
  return robot::RobotFolders(files, options.robots);
}

// Of a task without a robot: "".
std::filesystem::path RobotFile(const TaskOptions& options, const PluginFacts& plugin) {
  const std::string name = RobotName(options, plugin);
  return name.empty() ? "" : robot::FindRobotFile(name, RobotFoldersOf(options, plugin));
}

robot::RobotDescription ReadRobot(const TaskOptions& options, const PluginFacts& plugin,
                                  const std::filesystem::path& file) {
  return file.empty() ? robot::RobotDescription{}
                      : robot::ReadRobotCalled(RobotName(options, plugin), file);
}

AgentLayers LayersOf(const TaskOptions& options, const std::filesystem::path& robot_file) {
  const std::string& socket = options.environment_socket;
  return {robot_file.empty() ? AgentsWithoutRobot() : robot_file.parent_path(),
          options.task,
          options.agent,
          options.profile,
          socket.empty() ? "" : std::filesystem::absolute(socket).string(),
          options.settings};
}

std::shared_ptr<const Plugin> LoadAfter(const BeforeLoading& before_loading,
                                        const TaskSetup& known) {
  if (before_loading) before_loading(known);
  auto plugin = std::make_shared<const Plugin>(known.plugin_file);
  CheckHasEnd(plugin->table());
  return plugin;
}

}  // namespace

command_line::Option AddProfileOption(command_line::Command& command, std::string& profile) {
  std::vector<std::string> profiles;
  for (const Profile& each : kProfiles) profiles.emplace_back(each.name);
  return command
      .AddOption("--profile", profile,
                 "how to simulate: `paper` faithfully, `fast` with longer steps; with `-tree` the "
                 "same equations are solved several times as fast; `mujoco`: another engine")
      .OneOf(profiles);
}

void AddRobotsOption(command_line::Command& command, std::filesystem::path& robots) {
  command.AddOption("--robots", robots, "look for robots in this folder first").ValueName("DIR");
}

void TaskOptions::AddTo(command_line::Command& command) {
  command.AddOption("TASK", task, "a .task file, or a .so that taskc built from one").Required();
  AddProfileOption(command, profile);
  command
      .AddOption("--agent", agent,
                 "how to learn: one of the robot's agents (`trainer agent list`), or an agent file "
                 "that changes its default agent")
      .ValueName("AGENT|FILE.toml");
  command.AddOption("--robot", robot, "the robot, for a task that names none").ValueName("ROBOT");
  AddRobotsOption(command, robots);
  command
      .AddOption("--environment-socket", environment_socket,
                 "the environment of a task without a robot is the program that listens there")
      .ValueName("PATH");
  command
      .AddOption("--set", settings, "change a parameter, MODULE.PARAMETER=VALUE; may be repeated")
      .ValueName("SETTING")
      .OneAtATime();
}

BuiltTask::BuiltTask(const TaskOptions& options) {
  const std::filesystem::path& task = options.task;
  CheckTaskFile(task);
  if (task.extension() == ".so") {
    plugin_ = task;
    return;
  }
  scratch_.emplace();
  const std::filesystem::path built = scratch_->path() / "task.so";
  if (BuildTask({.task = task, .plugin = built, .robots = options.robots})) plugin_ = built;
}

TaskSetup::TaskSetup(const TaskOptions& wanted, const std::filesystem::path& file, uint64_t seed,
                     const ModuleTypes& program_types, const BeforeLoading& before_loading)
    : options(wanted),
      plugin_file(file),
      facts(before_loading ? ReadPluginFacts(file) : FactsOf(Plugin(file))),
      robot_file(RobotFile(options, facts)),
      robot(ReadRobot(options, facts, robot_file)),
      agent(LayersOf(options, robot_file).Merge()),
      changes(LayersOf(options, robot_file).Changes()),
      plugin(LoadAfter(before_loading, *this)),
      context{&robot, plugin, seed},
      types(WithComposites(WithLibraries(program_types, agent), agent)),
      graph(BuildGraph(agent, types, context)) {
  agent = Resolved(agent, graph);
  settings = LayersOf(options, robot_file).SettingsIn(agent, changes);
}

}  // namespace runtime
