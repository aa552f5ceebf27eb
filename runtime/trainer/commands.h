// The commands of `trainer`. Each adds itself to the command line, with its options and what it
// does: that returns the exit status, and throws UserError or CallError.
#pragma once

#include "base/command_line/command.h"

namespace runtime {

// Exit statuses. A run that was stopped by a signal ends with kStoppedBySignal + its number.
enum ExitStatus : int { kSuccess = 0, kFailed = 1, kWrongCall = 2, kStoppedBySignal = 128 };

void AddTrainCommand(command_line::Command& program);
void AddResumeCommand(command_line::Command& program);
void AddAgentCommand(command_line::Command& program);
void AddRobotCommand(command_line::Command& program);
void AddEnvironmentCommand(command_line::Command& program);
void AddServeCommand(command_line::Command& program);
void AddStudyCommand(command_line::Command& program);
void AddProbeCommand(command_line::Command& program);
void AddCtlCommand(command_line::Command& program);
void AddShowCommand(command_line::Command& program);
void AddEvaluateCommand(command_line::Command& program);
void AddReproduceCommand(command_line::Command& program);
void AddRescoreCommand(command_line::Command& program);
void AddReportCommand(command_line::Command& program);
void AddExportCommand(command_line::Command& program);
void AddSnapshotsCommand(command_line::Command& program);
void AddVideoCommand(command_line::Command& program);
void AddPreferCommand(command_line::Command& program);
void AddCompletionCommand(command_line::Command& program);

}  // namespace runtime
