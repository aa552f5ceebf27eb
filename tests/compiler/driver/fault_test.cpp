#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::HasSubstr;

constexpr const char* kTask =
    "task faulty\nsensor x: real\non end_of_time_step {\n  reward a = 1 / x\n"
    "  truncate_episode \"t\"\n}\n";

std::string Situation(const std::string& x) {
  return R"({"event": 5, "term": 0, "time_step": 0.005, "seed": 1, "discount": 1, "outcome": 2, "params": [],)"
         R"( "sensors": [[)" +
         x + R"(]], "memory": [[0]]})";
}

TEST(FaultVerb, ShowsWhereARewardThatIsNotFiniteComesFrom) {
  TaskcProcess taskc;
  taskc.Write("faulty.task", kTask);
  taskc.Write("fault.json", Situation("0"));
  EXPECT_THAT(taskc.Run("fault faulty.task fault.json").out,
              HasSubstr("faulty.task:4:14: `1 / x` is infinity\n  `x` is 0\n"));
  EXPECT_THAT(taskc.Run("fault faulty.task fault.json --json").out,
              HasSubstr("\"text\": \"1 / x\""));
  taskc.Write("fault.json", Situation("\"nan\""));
  EXPECT_THAT(taskc.Run("fault faulty.task fault.json").out,
              HasSubstr(":18: `x` is not a number\n"));
}

TEST(FaultVerb, RefusesWhatIsNoSituation) {
  TaskcProcess taskc;
  taskc.Write("faulty.task", kTask);
  taskc.Write("fault.json", "[]");
  EXPECT_EQ(taskc.Run("fault faulty.task fault.json").status, 2);
  EXPECT_EQ(taskc.Run("fault faulty.task none.json").status, 2);
  taskc.Write("fault.json", Situation("0, 1"));
  EXPECT_THAT(taskc.Run("fault faulty.task fault.json").error, HasSubstr("of another task"));
  taskc.Write("fault.json", Situation("2"));
  EXPECT_EQ(taskc.Run("fault faulty.task fault.json").status, 1);  // it is paid
}

}  // namespace
}  // namespace compiler
