// docs/api.md says of the commands what their table says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "runtime/live/control/command_table.h"

namespace runtime {
namespace {

const char* TypeText(ArgumentType type) {
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
std::string CommandRows() {
  std::string rows;
  for (const CommandSpec& command : Commands()) {
    rows += fmt::format("| **{}** | | {} | {} |\n", command.name,
                        command.changes() ? "POST" : "POST, GET", command.doc);
    for (const ArgumentSpec& argument : command.arguments) {
      rows += fmt::format("| | `{}` | {}{} | {} |\n", argument.name, TypeText(argument.type),
                          argument.is_required ? "" : ", optional", argument.doc);
    }
  }
  return rows;
}

TEST(Documentation, ListsEveryCommandAndArgument) {
  std::ostringstream page;
  page << std::ifstream(API_PAGE).rdbuf();
  EXPECT_NE(page.str().find(CommandRows()), std::string::npos)
      << "the table of commands in docs/api.md must be:\n"
      << CommandRows();
}

}  // namespace
}  // namespace runtime
