// `trainer`: runs compiled tasks on simulated robots that learn.
#include <fmt/format.h>

#include <csignal>
#include <functional>

#include "base/command_line/manual.h"
#include "base/text/print.h"
#include "runtime/trainer/commands.h"

namespace runtime {
namespace {

constexpr const char* kVersion = "trainer " TASKC_VERSION;

void Declare(command_line::Command& program) {
  program.ExitStatus(
      "0 success, 1 the task or the run failed, 2 the command line is wrong, 128 + n stopped by "
      "signal n.");
  AddTrainCommand(program);
  AddResumeCommand(program);
  AddServeCommand(program);
  AddStudyCommand(program);
  AddProbeCommand(program);
  AddCtlCommand(program);
  AddShowCommand(program);
  AddReportCommand(program);
  AddEvaluateCommand(program);
  AddReproduceCommand(program);
  AddRescoreCommand(program);
  AddExportCommand(program);
  AddSnapshotsCommand(program);
  AddVideoCommand(program);
  AddPreferCommand(program);
  AddAgentCommand(program);
  AddRobotCommand(program);
  AddEnvironmentCommand(program);
  AddCompletionCommand(program);
  command_line::AddManual(program, kVersion, "taskc");
  program.Version(kVersion);
  for (const auto& command : program.commands()) command->Version(kVersion);
}

int RunTrainer(int argc, char** argv) {
  command_line::Command program("trainer",
                                "Trains a simulated robot on a task written in the task language.");
  Declare(program);
  std::function<int()> action;
  try {
    action = program.Parse(argc, argv);
  } catch (const command_line::CallError& error) {
    text::Print(stderr, "trainer: error: {} (see `trainer --help`)\n", error.what());
    return kWrongCall;
  }
  return action ? action() : kSuccess;
}

}  // namespace
}  // namespace runtime

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error like any other
  try {
    return runtime::RunTrainer(argc, argv);
  } catch (const command_line::CallError& error) {
    text::Print(stderr, "trainer: error: {}\n", error.what());
    return runtime::kWrongCall;
  } catch (const std::exception& error) {
    text::Print(stderr, "trainer: error: {}\n", error.what());
    return runtime::kFailed;
  }
}
