// `taskc`: compiles tasks.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "compiler/driver/command_line.h"
#include "compiler/driver/crash_report.h"
#include "compiler/driver/print_error.h"

int main(int argc, char** argv) {
  using namespace compiler;
  ReportCrashes(argc, argv);
  ExitStatus status = RunCommandLine(argc, argv);
  if (std::fflush(stdout) != 0) {
    PrintError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
    status = Worse(status, ExitStatus::kWrongCall);
  }
  return static_cast<int>(status);
}
