// `trainer`: runs compiled tasks on simulated robots that learn.
#include <fmt/format.h>

#include <csignal>

#include "base/command_line/wrong_call.h"
#include "base/text/print.h"
#include "runtime/trainer/call_error.h"
#include "runtime/trainer/commands.h"

namespace runtime {
namespace {

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
  AddCompletionCommand(app, status);
  app.set_version_flag("--version", "trainer " TASKC_VERSION, "print the version and leave");
  for (CLI::App* command : app.get_subcommands({})) {
    command->set_version_flag("--version", "trainer " TASKC_VERSION, "print the version and leave");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    text::Print(stderr, "trainer: error: {} (see `trainer --help`)\n",
                command_line::WhatIsWrong(app, error));
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
    text::Print(stderr, "trainer: error: {}\n", error.what());
    return runtime::kWrongCall;
  } catch (const std::exception& error) {
    text::Print(stderr, "trainer: error: {}\n", error.what());
    return runtime::kFailed;
  }
}
