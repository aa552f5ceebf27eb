#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

constexpr const char* kTwoErrors =
    "task bad\non end_of_action {\n  reward a = x\n  reward b = y\n  let unused = 1\n"
    "  end_episode success \"\"\n}\n";

TEST(Check, SaysWhatAGoodTaskHas) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("check good.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "good.task: ok (2 sensors, 1 term, 1 end)\n");
  EXPECT_EQ(outcome.error, "");
}

// All verbs read files in the same way.
TEST(Check, SuggestsTheTaskWhoseEndingWasLeftOut) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  for (const char* verb : {"build", "check", "test", "emit", "fmt", "doc"}) {
    const Outcome outcome = taskc.Run(std::string(verb) + " good");
    EXPECT_EQ(outcome.status, 2) << verb;
    EXPECT_EQ(outcome.error,
              "taskc: cannot read `good`: No such file or directory; did you mean `good.task`?\n")
        << verb;
    EXPECT_EQ(taskc.Run(std::string(verb) + " bad").error,
              "taskc: cannot read `bad`: No such file or directory\n")
        << verb;
  }
}

TEST(Check, ShowsBounds) {
  TaskcProcess taskc;
  taskc.Write("bounded.task", R"(task bounded

sensor speed: real [m/s]
sensor tilt: real [rad]
metric mean lean = cos(tilt)

on end_of_time_step {
  reward rate forward = tanh(speed / 1 m * 2 s)
  if tilt > 1 rad { reward fall = -4 }
  reward rate fast = speed
  if speed > 9 m/s { end_episode success "fast" }
}
)");
  Outcome outcome = taskc.Run("check --bounds bounded.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, R"(bounded.task: ok (2 sensors, 3 terms, 1 end)
  name     what                   lowest    highest  unit
  forward  reward, per second         -1          1
  fall     reward, each time          -4         -4
  fast     reward, per second  unbounded  unbounded  m/s   the sensor `speed` has no range
  lean     metric                     -1          1
)");
  EXPECT_EQ(outcome.error, "");
}

TEST(Check, AcceptsThePapersTasks) {
  TaskcProcess taskc;
  auto files = golden::FilesIn(SOURCE_DIR "/tasks", "", ".task");
  EXPECT_GE(files.size(), 6u);  // and variants of them
  for (const auto& file : files) {
    Outcome outcome = taskc.Run("check '" + file.string() + "'");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, HasSubstr(".task: ok ("));
    EXPECT_EQ(outcome.error, "") << "not even a warning";
  }
}

TEST(Check, ShowsAllErrorsAndCountsThem) {
  TaskcProcess taskc;
  taskc.Write("bad.task", kTwoErrors);
  Outcome outcome = taskc.Run("check bad.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("bad.task:3:14"), HasSubstr("bad.task:4:14"),
                                   HasSubstr("  reward a = x"), HasSubstr("2 errors")));
}

TEST(Check, LooksAtEveryFile) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  taskc.Write("bad.task", kTwoErrors);
  Outcome outcome = taskc.Run("check bad.task good.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("good.task: ok"));
  outcome = taskc.Run("check absent.task bad.task good.task");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.out, HasSubstr("good.task: ok"));
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("`absent.task`"), HasSubstr("2 errors")));
}

TEST(Check, PassesATaskWithAWarning) {
  TaskcProcess taskc;
  taskc.Write("warned.task", "task warned\nmetric one = 1\n");
  Outcome outcome = taskc.Run("check warned.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("warned.task: ok"));
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("warning[W"), HasSubstr("\n1 warning;")));
}

TEST(Check, UsesNoColorWhereNobodySeesIt) {
  TaskcProcess taskc;
  taskc.Write("bad.task", kTwoErrors);
  EXPECT_THAT(taskc.Run("check bad.task").error, Not(HasSubstr("\033")));
}

TEST(Check, ShowsWhereAnUnknownRobotIsNamed) {
  TaskcProcess taskc;
  taskc.Write("lost.task", "task lost for humanoit\n");
  Outcome outcome = taskc.Run("check lost.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.error,
              AllOf(HasSubstr("E0212"), HasSubstr("lost.task:1:15"), HasSubstr("`humanoit`"),
                    HasSubstr("^^^^^^^^"), HasSubstr("humanoid"), HasSubstr("1 error;")));
}

TEST(Check, FindsRobotsBesideTheTaskAndWhereItIsTold) {
  TaskcProcess taskc;
  std::string robot = ReadWholeFile(SOURCE_DIR "/plugins/humanoid/robot.toml").value();
  robot.replace(robot.find("\"humanoid\""), 10, "\"walker\"");
  taskc.Write("tasks/walker/robot.toml", robot);
  taskc.Write("tasks/walk.task", "task walk for walker\nmetric x = base.position.x\n");
  EXPECT_EQ(taskc.Run("check tasks/walk.task").status, 0);
  taskc.Write("walk.task", "task walk for walker\nmetric x = base.position.x\n");
  EXPECT_EQ(taskc.Run("check walk.task").status, 1);
  EXPECT_EQ(taskc.Run("check walk.task --robots tasks").status, 0);
  EXPECT_EQ(taskc.Run("check walk.task", "TASKC_ROBOT_PATH=tasks").status, 0);
}

TEST(Check, FindsLibrariesWhereItIsTold) {
  TaskcProcess taskc;
  taskc.Write("shared/own/walks.task", "fn twice(x: real) -> real = 2 * x\n");
  taskc.Write("walk.task",
              "task walk for humanoid\nimport \"own/walks\"\nimport \"std/gait\"\n"
              "metric x = twice(base.position.x / 1 m) + phase_of(time, 1 s)\n");
  EXPECT_EQ(taskc.Run("check walk.task").status, 1);
  EXPECT_EQ(taskc.Run("check walk.task", "TASKC_LIBRARY_PATH=shared").status, 0);
}

TEST(Check, BlamesABrokenRobotOnItsFile) {
  TaskcProcess taskc;
  taskc.Write("broken/robot.toml", "name = \n");
  taskc.Write("t.task", "task t for broken\n");
  Outcome outcome = taskc.Run("check t.task");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("broken/robot.toml"));
}

// Whatever the file holds, there is a message and no crash.
TEST(Check, SurvivesAnyFile) {
  TaskcProcess taskc;
  std::mt19937 random(1);
  std::string noise;
  for (int i = 0; i < 20000; ++i) noise += static_cast<char>(random());
  std::string good = kGoodTask;
  std::string brackets(50000, '(');
  const std::string files[] = {"",
                               "\n",
                               noise,
                               std::string(100, '\0'),
                               good.substr(0, 70),
                               "task t\nmetric x = " + brackets,
                               "task t\non end_of_action {",
                               std::string(2000000, 'a')};
  for (const std::string& text : files) {
    taskc.Write("file.task", text);
    Outcome outcome = taskc.Run("check file.task");
    EXPECT_EQ(outcome.status, 1) << text.substr(0, 50);
    EXPECT_THAT(outcome.error, MatchesRegex(".*error\\[E[0-9]*\\](.|\n)*errors?; for more.*\n"));
  }
}

}  // namespace
}  // namespace compiler
