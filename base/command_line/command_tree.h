// The commands of a program and their options as data, read from the command line's own
// declarations: what the shells' completions are written from.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/command_line/command.h"

namespace command_line {

struct CompletedValue {
  enum Kind { kNone, kText, kWords, kTask, kFile, kFolder };
  Kind kind = kNone;
  std::vector<std::string> words = {};  // of kWords
};

struct CompletedOption {
  std::vector<std::string> names;  // "-o", "--output"
  std::string description;
  CompletedValue value;  // kNone: a flag
};

struct CompletedCommand {
  std::string path;  // "ctl module add"; "" of the program itself
  std::string name;  // the last word of it
  std::string title;
  std::vector<CompletedOption> options;
  CompletedValue argument;
  std::vector<std::string> commands;  // names of those below it
};

// Words for what the declarations cannot say, by the names of arguments: {"CODE", {"E0101"}}.
using ArgumentWords = std::map<std::string, std::vector<std::string>>;

// The program comes first, and each command before those below it.
std::vector<CompletedCommand> CommandsOf(const Command& program, const ArgumentWords& words);

}  // namespace command_line
