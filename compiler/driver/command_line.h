// The command line of `taskc`.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "compiler/driver/exit_status.h"

namespace compiler {

struct BuildCommand {
  std::string task;
  std::filesystem::path output;  // empty: leave the plugin in the cache and print its path
  std::filesystem::path cache;   // empty: the default
};
struct CheckCommand {
  std::vector<std::string> tasks;
};
struct EmitCommand {
  std::string task;
  std::filesystem::path output;  // empty: standard output
};

struct CommandLine {
  std::variant<BuildCommand, CheckCommand, EmitCommand> command;
  std::filesystem::path robots;  // where to look for robots first; may be empty
};

// The parsed command line, or the status with which to exit at once: help or version was asked for
// and is printed, or the call is wrong, which is said in one line on standard error.
std::variant<CommandLine, ExitStatus> ParseCommandLine(int argc, char** argv);

}  // namespace compiler
