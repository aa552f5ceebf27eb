#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// The new task passes without a warning, and is laid out as `taskc fmt` would.
void ExpectFlawless(const TaskcProcess& taskc, const std::string& file) {
  Outcome checked = taskc.Run("check " + file);
  EXPECT_EQ(checked.status, 0);
  EXPECT_EQ(checked.error, "");
  EXPECT_EQ(taskc.Run("fmt --check " + file).status, 0);
}

TEST(New, WritesATaskForARobot) {
  TaskcProcess taskc;
  Outcome outcome = taskc.Run("new walking --for humanoid");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "walking.task\n");
  EXPECT_THAT(ReadWholeFile(taskc.path("walking.task")).value(),
              AllOf(HasSubstr("task walking for humanoid\n"), HasSubstr("start standing"),
                    HasSubstr("left_knee_pitch"), HasSubstr("base.velocity: vec3 [m/s]")));
  ExpectFlawless(taskc, "walking.task");
  EXPECT_EQ(taskc.Run("test walking.task").status, 0);
}

TEST(New, WritesATaskWithItsOwnSensors) {
  TaskcProcess taskc;
  EXPECT_EQ(taskc.Run("new balancing.task").status, 0);
  ExpectFlawless(taskc, "balancing.task");
}

TEST(New, OverwritesNothing) {
  TaskcProcess taskc;
  taskc.Write("mine.task", "my work");
  Outcome outcome = taskc.Run("new mine");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("`mine.task` already exists"));
  EXPECT_EQ(ReadWholeFile(taskc.path("mine.task")), "my work");
}

TEST(New, RefusesWhatIsNoName) {
  TaskcProcess taskc;
  for (const char* name : {"2fast", "two-legs", "reward", "'a b'", "'x for humanoid'"}) {
    Outcome outcome = taskc.Run(std::string("new ") + name);
    EXPECT_EQ(outcome.status, 2) << name;
    EXPECT_THAT(outcome.error, HasSubstr("cannot be called")) << name;
  }
}

TEST(New, NamesTheRobotsThatThereAre) {
  TaskcProcess taskc;
  Outcome outcome = taskc.Run("new walking --for humanoit");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("`humanoit`"), HasSubstr("humanoid")));
  EXPECT_FALSE(std::filesystem::exists(taskc.path("walking.task")));
}

}  // namespace
}  // namespace compiler
