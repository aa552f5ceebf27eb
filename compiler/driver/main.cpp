// `taskc`: compiles tasks.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "compiler/build/internal_error.h"
#include "compiler/driver/command_line.h"
#include "compiler/driver/print_error.h"
#include "compiler/source/diagnostic.h"
#include "plugins/robot/robot_description.h"

namespace compiler {
namespace {

ExitStatus RunGuarded(int argc, char** argv) {
  try {
    return RunCommandLine(argc, argv);
  } catch (const CallError& error) {
    PrintError(error.what());
    return ExitStatus::kWrongCall;
  } catch (const robot::DescriptionError& error) {
    PrintError(error.what());
    return ExitStatus::kWrongCall;
  } catch (const InternalError& error) {
    PrintError(fmt::format("internal error: {}; please report this with the folder {}",
                           error.what(), error.evidence().string()));
  } catch (const std::exception& error) {
    PrintError(fmt::format("internal error: {}; please report this with the task", error.what()));
  }
  return ExitStatus::kInternalError;
}

}  // namespace
}  // namespace compiler

int main(int argc, char** argv) {
  using namespace compiler;
  ExitStatus status = RunGuarded(argc, argv);
  if (std::fflush(stdout) != 0) {
    PrintError(fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
    status = Worse(status, ExitStatus::kWrongCall);
  }
  return static_cast<int>(status);
}
