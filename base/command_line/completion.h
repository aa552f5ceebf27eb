#pragma once

#include <string>

#include "base/command_line/command_tree.h"

namespace command_line {

// The argument SHELL, for which completion is written: bash, zsh or fish.
void AddShell(Command& command, std::string& shell);

// The script with which `shell` completes the command line of `program`: commands, options, and the
// values that are words, files or folders.
std::string Completion(const std::string& shell, const Command& program,
                       const ArgumentWords& words = {});

}  // namespace command_line
