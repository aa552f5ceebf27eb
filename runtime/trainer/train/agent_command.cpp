#include <fmt/format.h>

#include "base/text/print.h"
#include "runtime/core/module/graph_text.h"
#include "runtime/trainer/commands.h"
#include "runtime/trainer/setup/task_setup.h"

namespace runtime {
namespace {

enum class AgentFormat { kToml, kText, kJson, kDot };

struct AgentOptions {
  TaskOptions task;
  AgentFormat format = AgentFormat::kToml;
};

std::string Show(const TaskSetup& setup, AgentFormat format) {
  switch (format) {
    case AgentFormat::kText:
      return GraphText(setup.graph);
    case AgentFormat::kJson:
      return GraphJson(setup.graph);
    case AgentFormat::kDot:
      return GraphDot(setup.graph);
    case AgentFormat::kToml:
      break;
  }
  return ToTomlWithPlaces(setup.agent);
}

int ShowAgent(const AgentOptions& options) {
  const BuiltTask task(options.task.task);
  if (!task.plugin()) return kFailed;
  text::Print("{}", Show(TaskSetup(options.task, *task.plugin(), 0), options.format));
  return kSuccess;
}

}  // namespace

void AddAgentCommand(CLI::App& app, int& status) {
  const std::map<std::string, AgentFormat> formats = {{"toml", AgentFormat::kToml},
                                                      {"text", AgentFormat::kText},
                                                      {"json", AgentFormat::kJson},
                                                      {"dot", AgentFormat::kDot}};
  CLI::App* command = app.add_subcommand("agent", "Looks at agents.");
  command->require_subcommand(1);
  const auto options = std::make_shared<AgentOptions>();
  CLI::App* show = command->add_subcommand(
      "show",
      "Prints the whole agent that would learn a task, as an agent file that says for each line "
      "where it comes from; or its modules and connections, as text, JSON or Graphviz.");
  options->task.AddTo(*show);
  CLI::Option* format = show->add_option("--format", options->format, "toml, text or dot")
                            ->transform(CLI::CheckedTransformer(formats).description(""))
                            ->type_name("toml|text|dot");
  show->add_flag_callback(
          "--json", [options] { options->format = AgentFormat::kJson; }, "print JSON")
      ->excludes(format);
  show->callback([options, &status] { status = ShowAgent(*options); });
}

}  // namespace runtime
