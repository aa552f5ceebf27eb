// Runs another program to its end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace compiler {

struct ChildProcess {
  std::vector<std::string> command;  // the first is a path
  std::filesystem::path input;       // what it reads
  std::filesystem::path output;      // gets what it prints, errors too
  std::filesystem::path scratch;     // for its temporary files
};

// The exit status; 128 + n where signal n ended it. Messages are in English whatever the user's
// locale. Throws CallError where the program cannot be started.
int Run(const ChildProcess& child);

}  // namespace compiler
