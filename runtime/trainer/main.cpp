// `trainer`: runs compiled tasks on simulated robots that learn.
#include <fmt/format.h>

#include <csignal>
#include <optional>

#include "plugins/text/nearest_name.h"
#include "runtime/trainer/call_error.h"
#include "runtime/trainer/commands.h"

namespace runtime {
namespace {

// What was probably meant, where the first word looks like one of the commands.
std::string SuggestedCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || !app.get_subcommands().empty()) return "";
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  const std::optional<std::string> nearest = text::NearestName(argv[1], commands);
  return nearest ? fmt::format("; did you mean `trainer {}`?", *nearest) : "";
}

int RunTrainer(int argc, char** argv) {
  CLI::App app("Trains a simulated robot in a task that was written in the task language.",
               "trainer");
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done, 1 the task or the run failed, 2 wrong call, 128 + n stopped by signal "
      "n.");
  int status = kSuccess;
  AddTrainCommand(app, status);
  AddResumeCommand(app, status);
  AddStudyCommand(app, status);
  AddShowCommand(app, status);
  AddReportCommand(app, status);
  AddAgentCommand(app, status);
  app.set_version_flag("--version", "trainer " TASKC_VERSION, "print the version and leave");
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_version_flag("--version", "trainer " TASKC_VERSION, "print the version and leave");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    fmt::print(stderr, "trainer: error: {}{} (see `trainer --help`)\n", error.what(),
               SuggestedCommand(app, argc, argv));
    return kWrongCall;
  }
  return status;
}

}  // namespace
}  // namespace runtime

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like any other
  try {
    return runtime::RunTrainer(argc, argv);
  } catch (const runtime::CallError& error) {
    fmt::print(stderr, "trainer: error: {}\n", error.what());
    return runtime::kWrongCall;
  } catch (const std::exception& error) {
    fmt::print(stderr, "trainer: error: {}\n", error.what());
    return runtime::kFailed;
  }
}
