// What docs/api.md has to say of commands.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <span>
#include <sstream>
#include <string>

#include "runtime/live/control/command.h"

namespace runtime {

inline const char* TypeWords(ArgumentType type) {
  switch (type) {
    case ArgumentType::kText:
    case ArgumentType::kTaskFile:
      return "string";
    case ArgumentType::kWhole:
      return "integer";
    case ArgumentType::kNumber:
      return "number";
    case ArgumentType::kFlag:
      return "boolean";
    case ArgumentType::kValue:
      return "number, boolean, string or list of numbers";
    case ArgumentType::kObject:
      return "object";
  }
  return "";
}

// A row for each command, and one for each of its arguments.
inline std::string CommandRows(std::span<const CommandSpec> commands) {
  std::string rows;
  for (const CommandSpec& command : commands) {
    rows += fmt::format("| **{}** | | {} | {} |\n", command.name,
                        command.changes() ? "POST" : "POST, GET", command.doc);
    for (const ArgumentSpec& argument : command.arguments) {
      rows += fmt::format("| | `{}` | {}{} | {} |\n", argument.name, TypeWords(argument.type),
                          argument.is_required ? "" : ", optional", argument.doc);
    }
  }
  return rows;
}

inline void ExpectListed(const std::string& page_file, std::span<const CommandSpec> commands) {
  std::ostringstream page;
  page << std::ifstream(page_file).rdbuf();
  EXPECT_NE(page.str().find(CommandRows(commands)), std::string::npos)
      << "a table of commands in " << page_file << " must be:\n"
      << CommandRows(commands);
}

}  // namespace runtime
