// The commands of a program and their options as data, read from the command line's own
// declarations: what the shells' completions and the manual are written from.
#pragma once

#include <string>
#include <vector>

#include "base/command_line/command.h"
#include "base/command_line/completed_value.h"

namespace command_line {

// An option, a flag or an argument.
struct OptionEntry {
  std::vector<std::string> names;  // "-o", "--output"; of an argument "FILE.task"
  std::string description;
  std::string value;          // "DIR"; "" of flags and arguments
  std::string limits;         // "in [1, 100]"
  std::string default_value;  // where the help shows it
  bool is_flag = false;
  bool is_required = false;
  bool takes_many = false;
  std::vector<std::string> needs;     // "--output"
  std::vector<std::string> excludes;  // "--json"
  CompletedValue completed;
};

struct CommandEntry {
  std::string path;  // "ctl module add"; "" of the program itself
  std::string name;  // the last word of it
  std::string title;
  std::string group;  // under which the command above lists it
  std::vector<OptionEntry> options;
  std::vector<OptionEntry> arguments;  // in their order
  std::vector<std::string> commands;   // names of those below it
  CommandNotes notes;
};

// What is hidden is left out. The program comes first, and each command before those below it.
std::vector<CommandEntry> CommandsOf(const Command& program, const ValueLists& lists);

// The command `name` below `command`.
const CommandEntry& Below(const CommandEntry& command, const std::string& name,
                          const std::vector<CommandEntry>& commands);

}  // namespace command_line
