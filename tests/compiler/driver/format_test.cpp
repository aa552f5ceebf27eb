// The forms in which taskc reports, and their colors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/compiler/driver/taskc_process.h"
#include "tests/terminal.h"

namespace compiler {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kBadTask = "task bad\non end_of_action {\n  reward a = x\n}\n";

TEST(Format, JsonHasTheDiagnosticsAndWhatBecameOfEachTask) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  taskc.Write("bad.task", kBadTask);
  Outcome outcome = taskc.Run("check good.task bad.task absent.task --json");
  EXPECT_EQ(outcome.status, 2);
  json report = json::parse(outcome.out);
  EXPECT_EQ(report["exit_status"], 2);
  EXPECT_EQ(report["errors"], 1);
  EXPECT_EQ(report["warnings"], 0);
  ASSERT_EQ(report["tasks"].size(), 2u);
  EXPECT_EQ(report["tasks"][0], (json{{"file", "good.task"},
                                      {"ok", true},
                                      {"files", {"good.task"}},
                                      {"name", "good"},
                                      {"sensors", 2},
                                      {"terms", 1},
                                      {"ends", 1}}));
  EXPECT_EQ(report["tasks"][1],
            (json{{"file", "bad.task"}, {"ok", false}, {"files", {"bad.task"}}}));
  EXPECT_EQ(report["diagnostics"][0]["code"], "E0201");
  EXPECT_EQ(report["diagnostics"][0]["line"], 3);
  EXPECT_THAT(report["failures"][0].get<std::string>(), HasSubstr("absent.task"));
}

TEST(Format, JsonHasTheBoundsThatAreAskedFor) {
  TaskcProcess taskc;
  taskc.Write("bounded.task",
              "task bounded\nsensor speed: real [m/s]\non end_of_time_step {\n"
              "  reward rate forward = abs(speed)\n"
              "  if speed > 9 m/s { end_episode success \"fast\" }\n}\n");
  json report = json::parse(taskc.Run("check --bounds bounded.task --json").out);
  EXPECT_EQ(report["tasks"][0]["bounds"],
            json::array({{{"name", "forward"},
                          {"kind", "rate"},
                          {"low", 0},
                          {"high", nullptr},
                          {"unit", "m/s"},
                          {"may_happen", true},
                          {"may_be_nan", false},
                          {"unbounded_by", {"the sensor `speed` has no range"}}}}));
}

TEST(Format, JsonSaysWhereThePluginIs) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  std::string plugin = taskc.Run("build good.task").out;
  json report = json::parse(taskc.Run("build good.task --json").out);
  EXPECT_EQ(report["tasks"][0]["plugin"].get<std::string>() + "\n", plugin);
  report = json::parse(taskc.Run("build good.task -o out.so --json").out);
  EXPECT_EQ(report["tasks"][0]["plugin"], "out.so");
}

TEST(Format, JsonIsWholeEvenWhereNothingCouldBeDone) {
  TaskcProcess taskc;
  Outcome outcome = taskc.Run("build absent.task --json");
  EXPECT_EQ(outcome.status, 2);
  json report = json::parse(outcome.out);
  EXPECT_EQ(report["tasks"], json::array());
  EXPECT_EQ(report["failures"].size(), 1u);
}

TEST(Format, SarifNamesItsVersionAndTheResults) {
  TaskcProcess taskc;
  taskc.Write("bad.task", kBadTask);
  Outcome outcome = taskc.Run("check bad.task --sarif");
  EXPECT_EQ(outcome.status, 1);
  json report = json::parse(outcome.out);
  EXPECT_EQ(report["version"], "2.1.0");
  EXPECT_EQ(report["runs"][0]["results"][0]["ruleId"], "E0201");
}

TEST(Format, IsOne) {
  TaskcProcess taskc;
  Outcome outcome = taskc.Run("check x.task --json --sarif");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("--json excludes --sarif"));
}

TEST(Format, IsStillKnownByItsOldOption) {
  TaskcProcess taskc;
  taskc.Write("bad.task", kBadTask);
  EXPECT_EQ(taskc.Run("check bad.task --format json").out, taskc.Run("check bad.task --json").out);
  EXPECT_EQ(taskc.Run("check bad.task --format sarif").out,
            taskc.Run("check bad.task --sarif").out);
  EXPECT_THAT(taskc.Run("check x.task --format xml").error,
              HasSubstr("xml not in {text,json,sarif}"));
  EXPECT_THAT(taskc.Run("check --help").out,
              AllOf(HasSubstr("--json"), Not(HasSubstr("--format"))));
}

TEST(Color, IsThereOnWish) {
  TaskcProcess taskc;
  taskc.Write("bad.task", kBadTask);
  EXPECT_THAT(taskc.Run("check bad.task --color always", "NO_COLOR=1").error, HasSubstr("\033["));
  EXPECT_THAT(taskc.Run("check bad.task --color auto").error, Not(HasSubstr("\033[")));
}

// What `taskc check bad.task` prints on a terminal of its own.
std::string CheckOnTerminal(const TaskcProcess& taskc, const std::string& environment) {
  return PrintedOnTerminal(
      {"/bin/sh", "-c",
       "cd '" + taskc.path("").string() + "' && " + environment + " '" TASKC "' check bad.task"});
}

TEST(Color, IsThereOnATerminalUnlessNotWished) {
  if (!HasTerminals()) GTEST_SKIP() << "there are no terminals here";
  TaskcProcess taskc;
  taskc.Write("bad.task", kBadTask);
  EXPECT_THAT(CheckOnTerminal(taskc, "env -u NO_COLOR"), HasSubstr("\033["));
  std::string plain = CheckOnTerminal(taskc, "NO_COLOR=1");
  EXPECT_THAT(plain, AllOf(HasSubstr("E0201"), Not(HasSubstr("\033["))));
}

TEST(Text, SaysOnceWhereThereIsMore) {
  TaskcProcess taskc;
  taskc.Write("warned.task", "task warned\nmetric one = 1\n");
  taskc.Write("bad.task", kBadTask);
  EXPECT_THAT(taskc.Run("check warned.task bad.task").error,
              EndsWith("\n1 error, 1 warning; for more: taskc explain E0201\n"));
}

}  // namespace
}  // namespace compiler
