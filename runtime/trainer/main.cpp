// `trainer`: runs compiled tasks on simulated robots that learn.
#include <fmt/format.h>

#include <csignal>
#include <optional>

#include "plugins/text/nearest_name.h"
#include "runtime/trainer/call_error.h"
#include "runtime/trainer/commands.h"

namespace runtime {
namespace {

// What was probably meant, where a word looks like one of the commands that may stand there.
std::string SuggestedCommand(const CLI::App& app, int argc, char** argv) {
  const CLI::App* chosen = &app;
  std::string line = app.get_name();
  int position = 1;
  for (; !chosen->get_subcommands().empty(); ++position) {
    chosen = chosen->get_subcommands().front();
    line += " " + chosen->get_name();
  }
  if (position >= argc) return "";
  std::vector<std::string> commands;
  for (const CLI::App* command : chosen->get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  const std::optional<std::string> nearest = text::NearestName(argv[position], commands);
  return nearest ? fmt::format("; did you mean `{} {}`?", line, *nearest) : "";
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
  AddServeCommand(app, status);
  AddStudyCommand(app, status);
  AddCtlCommand(app, status);
  AddShowCommand(app, status);
  AddReportCommand(app, status);
  AddEvaluateCommand(app, status);
  AddSnapshotsCommand(app, status);
  AddPreferCommand(app, status);
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
