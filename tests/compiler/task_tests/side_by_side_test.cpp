// A plugin that computes something else than its task says is found out.
#include "compiler/task_tests/side_by_side.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/compiler/task_tests/built_task.h"

namespace compiler {
namespace {

using testing::HasSubstr;

// Two tasks of one outline, so that the plugin of one can stand for that of the other.
std::string TaskWith(const std::string& statements) {
  return "task built\nsensor x: real\nsensor n: int\nmemory kept: real = 0\nmetric shown = kept\n"
         "on end_of_time_step {\n  reward paid = x\n" +
         statements + "\n  end_episode success \"a\"\n}\n";
}

// What is said when the plugin of one is held against the other.
std::string Differing(const std::string& built, const std::string& meant) {
  const BuiltTask other(TaskWith(built));
  const BuiltTask task(TaskWith(meant));
  SideBySide both(task.task(), *other.plugin);
  both.SetSensor(0, Reals{0.5});
  try {
    both.Fire(EventKind::kEndOfTimeStep, 0.005);
  } catch (const Disagreement& found) {
    return found.what();
  }
  return "";
}

TEST(SideBySide, AgreesOnTheSame) { EXPECT_EQ(Differing("kept = x", "kept = x"), ""); }

TEST(SideBySide, FindsWhatDiffers) {
  EXPECT_EQ(Differing("kept += x + 0.25", "kept += x"),
            "after `end_of_time_step`, memory `kept`[0] is 0.75 in the plugin and 0.5 in the "
            "evaluator");
  EXPECT_THAT(Differing("reward paid = 2 * x", "reward paid = x"),
              HasSubstr("the reward is 1.5 in the plugin and 1 in the evaluator"));
  // In their last bits.
  EXPECT_NE(Differing("kept = x * 3 * 0.1", "kept = x * 3 / 10"), "");
  EXPECT_THAT(Differing("kept = -0.0 * x", "kept = 0 * x"), HasSubstr("is -0 in the plugin"));
}

TEST(SideBySide, CountsAllThatIsNoNumberAsTheSame) {
  const BuiltTask task(TaskWith("kept = x - x"));
  SideBySide both(task.task(), *task.plugin);
  const double infinity = std::numeric_limits<double>::infinity();
  for (double value : {infinity, -infinity, -std::numeric_limits<double>::quiet_NaN()}) {
    both.SetSensor(0, Reals{value});
    EXPECT_NO_THROW(both.Fire(EventKind::kEndOfTimeStep, 0.005));
  }
}

TEST(SideBySide, SetsBoth) {
  const BuiltTask task(
      "task built\nparam gain: int = 2\nsensor seen: bool[3]\nmemory kept: int = 1\n"
      "metric shown = kept\n"
      "on end_of_action {\n  if seen[1] { kept += gain }\n"
      "  end_episode success \"a\"\n}\n");
  SideBySide both(task.task(), *task.plugin);
  both.SetSensor(0, Integers{0, 1, 0});
  both.SetParam(0, 5);
  both.SetMemory(0, Integers{1000});
  both.Fire(EventKind::kEndOfAction, 0);
  EXPECT_EQ(both.evaluator().frame().memory[0], Value(Integers{1005}));
}

}  // namespace
}  // namespace compiler
