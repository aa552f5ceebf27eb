// The command line of `taskc`.
#pragma once

#include "compiler/driver/exit_status.h"

namespace compiler {

// Parses the command line and does what it says. Where help or a version is asked for, it is
// printed; what keeps the verb from its work is said in one line on standard error.
ExitStatus RunCommandLine(int argc, char** argv);

}  // namespace compiler
