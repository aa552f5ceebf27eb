#include <memory>
#include <string>

#include "base/text/print.h"
#include "runtime/core/module/graph_text.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {
namespace {

struct AgentOptions {
  TaskOptions task;
  std::string format = "toml";
  bool json = false;
};

std::string Show(const TaskSetup& setup, const AgentOptions& options) {
  if (options.json || options.format == "json") return GraphJson(setup.graph);
  if (options.format == "text") return GraphText(setup.graph);
  if (options.format == "dot") return GraphDot(setup.graph);
  return ToTomlWithPlaces(setup.agent);
}

int ShowAgent(const AgentOptions& options) {
  const BuiltTask task(options.task.task);
  if (!task.plugin()) return kFailed;
  text::Print("{}", Show(TaskSetup(options.task, *task.plugin(), 0), options));
  return kSuccess;
}

}  // namespace

void AddAgentCommand(command_line::Command& program) {
  const auto options = std::make_shared<AgentOptions>();
  command_line::Command& show =
      program.AddCommand("agent", "Inspects agents.")
          .AddCommand(
              "show",
              "Prints the complete agent that would learn a task, as an agent file that says where "
              "each line comes from; or its modules and connections, as text, JSON or Graphviz.");
  options->task.AddTo(show);
  const command_line::Option format =
      show.AddOption("--format", options->format,
                     "an agent file, or the modules and connections as text or for Graphviz")
          .OneOf({"toml", "text", "json", "dot"})
          .ValueName("toml|text|dot");
  show.AddFlag("--json", options->json, "print JSON").Excludes(format);
  show.OnRun([options] { return ShowAgent(*options); });
}

}  // namespace runtime
