// Completion of a program's command line in shells: scripts that are written from the declarations.
#pragma once

#include <functional>
#include <string>

#include "base/command_line/command.h"
#include "base/command_line/completed_value.h"

namespace command_line {

// The script with which `shell`, one of bash, zsh and fish, completes the command line of
// `program`: commands, options, and the values that are words, names, files or folders. Names it
// asks the program for: `PROGRAM completion --names ROBOT --line "the line"`, for each key of
// `lists.names`.
std::string Completion(const std::string& shell, const Command& program,
                       const ValueLists& lists = {});

// Declares what the command `completion` takes, with examples; what is returned prints what was
// asked for: a script, or names, one in a line. It may throw CallError.
std::function<void()> DeclareCompletion(Command& command, ValueLists lists);

}  // namespace command_line
