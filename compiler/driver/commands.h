// What `taskc` does for each of its commands.
#pragma once

#include "compiler/driver/command_line.h"
#include "compiler/driver/exit_status.h"

namespace compiler {

// Throws CallError, robot::DescriptionError and InternalError.
ExitStatus Execute(const CommandLine& line);

}  // namespace compiler
