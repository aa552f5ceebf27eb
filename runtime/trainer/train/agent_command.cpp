#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text/print.h"
#include "plugins/robot/robot_description.h"
#include "plugins/robot/robot_names.h"
#include "runtime/core/module/graph_text.h"
#include "runtime/core/module/layout_text.h"
#include "runtime/core/task/task_instance.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/setup/agent_presets.h"
#include "runtime/trainer/setup/apart.h"
#include "runtime/trainer/setup/sandbox_rules.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {
namespace {

struct AgentOptions {
  TaskOptions task;
  std::string format = "toml";
  bool json = false;
};

std::string Comment(const std::string& what, const ObservationLayout& layout) {
  return fmt::format("\n# {}:\n{}", what, ToText(layout, "#   "));
}

// What a learner sees, as comments of the agent file.
std::string ObservationsOf(const TaskSetup& setup) {
  std::string text;
  for (const auto& module : setup.graph.modules()) {
    const auto layout = LayoutShownBy(*module);
    if (!layout) continue;
    text += Comment(fmt::format("`{}` shows a learner {} numbers", module->name(), layout->size()),
                    *layout);
  }
  const ObservationLayout observed = ObservationLayoutOf(setup.plugin->table());
  if (!text.empty() || observed.values.empty()) return text;
  return Comment("The task observes this, and no module `Observation` shows it to a learner",
                 observed);
}

std::string Show(const TaskSetup& setup, const AgentOptions& options) {
  if (options.json || options.format == "json") return GraphJson(setup.graph);
  if (options.format == "text") return GraphText(setup.graph);
  if (options.format == "dot") return GraphDot(setup.graph);
  return ToTomlWithPlaces(setup.agent) + ObservationsOf(setup);
}

int ShowAgent(const AgentOptions& options) {
  const BuiltTask task(options.task);
  if (!task.plugin()) return kFailed;
  WarnWhereSandboxIsWeak();
  const Words shown = RunApart(options.task.task.string(), [&]() -> Words {
    return {Show(SetUpInSandbox(options.task, *task.plugin(), 0), options)};
  });
  text::Print("{}", shown.front());
  return kSuccess;
}

struct ListOptions {
  std::string robot;
  std::filesystem::path robots;
  bool json = false;
};

nlohmann::ordered_json ToJson(const AgentPreset& preset, const std::string& robot) {
  return {{"name", preset.name}, {"robot", robot}, {"doc", preset.doc}};
}

int ListAgents(const ListOptions& options) {
  const std::vector<std::filesystem::path> folders = robot::RobotFolders({}, options.robots);
  const std::vector<std::string> robots =
      options.robot.empty() ? robot::RobotNames(folders) : std::vector{options.robot};
  auto list = nlohmann::ordered_json::array();
  for (const std::string& robot : robots) {
    for (const AgentPreset& preset :
         AgentPresetsOf(robot::FindRobotFile(robot, folders).parent_path())) {
      list.push_back(ToJson(preset, robot));
      if (!options.json) text::Print("{:<16} {:<16} {}\n", preset.name, robot, preset.doc);
    }
  }
  if (options.json) text::Print("{}\n", list.dump());
  return kSuccess;
}

void AddListCommand(command_line::Command& agent) {
  const auto options = std::make_shared<ListOptions>();
  command_line::Command& list =
      agent.AddCommand("list", "Prints the agents that come with each robot, for `--agent`.");
  list.AddOption("--robot", options->robot, "only those of this robot").ValueName("ROBOT");
  AddRobotsOption(list, options->robots);
  list.AddFlag("--json", options->json, "print JSON");
  list.OnRun([options] { return ListAgents(*options); });
}

}  // namespace

void AddAgentCommand(command_line::Command& program) {
  const auto options = std::make_shared<AgentOptions>();
  command_line::Command& agent = program.AddCommand("agent", "Lists and inspects agents.");
  AddListCommand(agent);
  command_line::Command& show = agent.AddCommand(
      "show",
      "Prints the complete agent that would learn a task, as an agent file that says where each "
      "line comes from; or its modules and connections, as text, JSON or Graphviz.");
  options->task.AddTo(show);
  const command_line::Option format =
      show.AddOption("--format", options->format,
                     "an agent file, or the modules and connections as text or for Graphviz")
          .OneOf({"toml", "text", "json", "dot"})
          .ValueName("toml|text|dot");
  show.AddFlag("--json", options->json, "print JSON").Excludes(format);
  AddSandboxOption(show);
  show.OnRun([options] { return ShowAgent(*options); });
}

}  // namespace runtime
