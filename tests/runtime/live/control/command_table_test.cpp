#include "runtime/live/control/command_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

std::string ErrorOfCall(const char* command, const nlohmann::json& arguments) {
  try {
    CheckArguments(FindCommand(command), arguments);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

// That each has a handler, compiler and linker know.
TEST(CommandTable, EachRowIsComplete) {
  std::set<std::string> names;
  for (const CommandSpec& command : Commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_STRNE(command.doc, "") << command.name;
    std::set<std::string> arguments;
    for (const ArgumentSpec& argument : command.arguments) {
      EXPECT_TRUE(arguments.insert(argument.name).second) << command.name << " " << argument.name;
      EXPECT_STRNE(argument.doc, "") << command.name << " " << argument.name;
    }
  }
}

TEST(CommandTable, WhatIsDoneWithARequestFollowsFromItsRow) {
  EXPECT_FALSE(FindCommand("get").changes());
  EXPECT_TRUE(FindCommand("pause").changes());
  EXPECT_TRUE(FindCommand("save").changes());
  EXPECT_STREQ(FindCommand("swap").task_file()->name, "file");
  EXPECT_EQ(FindCommand("set").task_file(), nullptr);
}

TEST(CommandTable, AMisspelledCommandIsToldTheNearest) {
  try {
    FindCommand("swop");
    FAIL();
  } catch (const UserError& error) {
    EXPECT_STREQ(error.what(), "there is no command `swop`: did you mean `swap`?");
  }
}

TEST(CommandTable, ArgumentsAreChecked) {
  EXPECT_EQ(ErrorOfCall("swap", {{"name", "task"}, {"file", "a.task"}, {"now", true}}), "");
  EXPECT_EQ(ErrorOfCall("set", {{"name", "task.gain"}, {"value", 0.5}}), "");
  EXPECT_EQ(ErrorOfCall("set", {{"name", "task.gain"}, {"value", "20 s"}}), "");
  EXPECT_EQ(ErrorOfCall("status", nlohmann::json::array()),
            "the arguments of `status` must be a JSON object");
  EXPECT_EQ(ErrorOfCall("swap", {{"name", "task"}}),
            "`swap` needs the argument `file`: a .task file, or a .so built by taskc");
  EXPECT_EQ(ErrorOfCall("swap", {{"name", "task"}, {"file", 3}}),
            "the argument `file` of `swap` must be a string");
  EXPECT_EQ(ErrorOfCall("step", {{"count", 1.5}}),
            "the argument `count` of `step` must be an integer");
  EXPECT_EQ(ErrorOfCall("set", {{"name", "task.gain"}, {"value", nullptr}}),
            "the argument `value` of `set` must be a number, a boolean, a string or a list of "
            "numbers");
  EXPECT_EQ(ErrorOfCall("unload", {{"name", "task"}, {"nmae", "task"}}),
            "`unload` has no argument `nmae`: did you mean `name`?");
}

}  // namespace
}  // namespace runtime
