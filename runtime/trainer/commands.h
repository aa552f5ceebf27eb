// The subcommands of `trainer`. Each adds itself to the command line; when it is the chosen one, it
// runs while the line is parsed and sets `status` to the exit status. Errors are thrown.
#pragma once

#include <CLI/CLI.hpp>

namespace runtime {

// Exit statuses. A run that was stopped by a signal ends with kStoppedBySignal + its number.
enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongCall = 2, kStoppedBySignal = 128 };

void AddTrainCommand(CLI::App& app, int& status);
void AddResumeCommand(CLI::App& app, int& status);
void AddAgentCommand(CLI::App& app, int& status);
void AddServeCommand(CLI::App& app, int& status);
void AddStudyCommand(CLI::App& app, int& status);
void AddCtlCommand(CLI::App& app, int& status);
void AddShowCommand(CLI::App& app, int& status);
void AddEvaluateCommand(CLI::App& app, int& status);
void AddReportCommand(CLI::App& app, int& status);
void AddSnapshotsCommand(CLI::App& app, int& status);
void AddPreferCommand(CLI::App& app, int& status);
void AddCompletionCommand(CLI::App& app, int& status);

}  // namespace runtime
