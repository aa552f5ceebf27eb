#include "compiler/driver/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "compiler/driver/print_error.h"
#include "plugins/text/nearest_name.h"

namespace compiler {
namespace {

constexpr const char* kDescription =
    "Compiles tasks for robots that learn: .task files become plugins for the trainer.";

constexpr const char* kFooter =
    "Environment: CXX, the C++ compiler; TASKC_CACHE, the folder of built plugins;\n"
    "TASKC_ROBOT_PATH, folders with robots; NO_COLOR, no colours.\n"
    "Exit status: 0 fine, 1 the task has errors, 2 the call is wrong, 3 an error in taskc.";

// What is wrong with the call, in one line.
std::string Explain(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  if (app.get_subcommands().empty() && (argc < 2 || argv[1][0] != '-')) {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
      commands.push_back(command->get_name());
    }
    if (argc < 2) return fmt::format("expected a command: {}", fmt::join(commands, ", "));
    auto nearest = text::NearestName(argv[1], commands);
    return fmt::format("there is no command `{}`{}", argv[1],
                       nearest ? fmt::format("; did you mean `taskc {}`?", *nearest) : "");
  }
  std::string message = error.what();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

void AddRobots(CLI::App* command, std::filesystem::path& robots) {
  command->add_option("--robots", robots, "look for robots in this folder first")->type_name("DIR");
}

}  // namespace

std::variant<CommandLine, ExitStatus> ParseCommandLine(int argc, char** argv) {
  CommandLine line;
  BuildCommand build;
  CheckCommand check;
  EmitCommand emit;

  CLI::App app(kDescription, "taskc");
  app.footer(kFooter);
  app.set_version_flag("--version", "taskc " TASKC_VERSION);
  app.require_subcommand(1);

  CLI::App* build_app = app.add_subcommand("build", "Build a task into a plugin");
  build_app->add_option("FILE.task", build.task, "the task")->required()->type_name("");
  build_app
      ->add_option("-o,--output", build.output,
                   "the plugin; without, it stays in the cache and its path is printed")
      ->type_name("FILE.so");
  build_app->add_option("--cache", build.cache, "the folder of built plugins")->type_name("DIR");
  AddRobots(build_app, line.robots);

  CLI::App* check_app = app.add_subcommand("check", "Check tasks, build nothing");
  check_app->add_option("FILE.task", check.tasks, "the tasks")->required()->type_name("...");
  AddRobots(check_app, line.robots);

  CLI::App* emit_app = app.add_subcommand("emit", "Show the C++ that a task becomes");
  emit_app->add_option("FILE.task", emit.task, "the task")->required()->type_name("");
  emit_app->add_option("-o,--output", emit.output, "the C++ file; without, it is printed")
      ->type_name("FILE.cpp");
  AddRobots(emit_app, line.robots);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // --help, --version
    app.exit(wish);
    return ExitStatus::kOk;
  } catch (const CLI::ParseError& error) {
    PrintError(fmt::format("{} (see `taskc --help`)", Explain(app, error, argc, argv)));
    return ExitStatus::kWrongCall;
  }

  if (build_app->parsed()) line.command = build;
  if (check_app->parsed()) line.command = check;
  if (emit_app->parsed()) line.command = emit;
  return line;
}

}  // namespace compiler
