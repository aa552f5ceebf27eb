#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/compiler/driver/taskc_process.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kTested = R"(task tested
sensor speed: real [m/s]

on end_of_time_step {
  reward rate gain = speed / 1 m
  if speed > 2 m/s { end_episode success "fast" }
}

test "speed pays" {
  given speed = 1 m/s
  given time_step = 0.5 s
  fire 2 * end_of_time_step
  expect total(gain) == 1
}

test "haste ends" {
  given speed = 3 m/s
  fire end_of_time_step
  expect end_episode success "fast"
}

test "rest pays" {
  fire end_of_time_step
  expect total(gain) == 4
}
)";

TEST(TestVerb, SaysForEachTestWhetherItHolds) {
  TaskcProcess taskc;
  taskc.Write("tested.task", kTested);
  const Outcome outcome = taskc.Run("test tested.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out,
            "ok      speed pays\nok      haste ends\nFAILED  rest pays\n"
            "        tested.task:24: expect total(gain) == 4\n"
            "            total(gain) is 0\n"
            "tested.task: 3 tests, 1 failed\n");
}

TEST(TestVerb, RunsOnlyThoseThatAreAskedFor) {
  TaskcProcess taskc;
  taskc.Write("tested.task", kTested);
  const Outcome outcome = taskc.Run("test tested.task --filter speed");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("ok      speed pays\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("rest pays")));
}

TEST(TestVerb, SaysTheSameAsJson) {
  TaskcProcess taskc;
  taskc.Write("tested.task", kTested);
  const Outcome outcome = taskc.Run("test tested.task --json");
  EXPECT_EQ(outcome.status, 1);
  const auto tests = nlohmann::json::parse(outcome.out)["tasks"][0]["tests"];
  ASSERT_EQ(tests.size(), 3u);
  EXPECT_EQ(tests[0]["passed"], true);
  EXPECT_EQ(tests[2]["passed"], false);
  EXPECT_EQ(tests[2]["failures"].size(), 1u);
}

TEST(TestVerb, TestsNothingThatIsWrong) {
  TaskcProcess taskc;
  taskc.Write("wrong.task", "task wrong\ntest \"x\" { expect nothing }\n");
  const Outcome outcome = taskc.Run("test wrong.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error, HasSubstr("error[E0201]"));
}

TEST(TestVerb, HoldsForThePapersTasks) {
  TaskcProcess taskc;
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    const Outcome outcome = taskc.Run("test " + file.string());
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.error;
    EXPECT_THAT(outcome.out, EndsWith("all ok\n"));
  }
}

}  // namespace
}  // namespace compiler
