// What the exit status of `taskc` says.
#pragma once

namespace compiler {

enum class ExitStatus {
  kOk = 0,
  kWrongTask = 1,     // the task has errors
  kWrongCall = 2,     // an option, a file or the machine
  kInternalError = 3  // our mistake
};

// Of two outcomes the one to report.
inline ExitStatus Worse(ExitStatus a, ExitStatus b) { return a < b ? b : a; }

}  // namespace compiler
