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

// A function that is too long to optimize, with everything that is written out in a short one.
TEST(SideBySide, AgreesOnALongFunction) {
  const BuiltTask task(R"(task built
sensor u: real[9]
sensor q: quat
sensor c: bool[9]
memory v: vec3 = 0
memory w: real[9] = 0
memory seen: bool[9] = false
fn turned(x: real[9]) -> real[9] = x[8, 7, 6, 5, 4, 3, 2, 1, 0] * 0.75
on end_of_time_step {
  for i in 0..39 {
    for k in 0..2 {
      let x = turned(u * (i + 1) + w) / 3
      w[5, 3, 1, 0, 7, 8] = x[0..5] + w[3..8] * 0.125
      v = cross(v, x[2, 4, 6][0] * inverse(q).xyz) + rotate(q, v) / 7
      seen[0, 2, 4, 6, 8, 7] = c[3..8]
      if any(seen) and not all(c) { reward touch = norm(x) * count(seen) + min(x) - max(w) }
      reward rate turn = dot(v, v) * exp(-sum(x) / 50) + select(c[k], 1, tanh(v[k]))
    }
  }
  if norm(w) > 1e6 { end_episode success "far" }
}
)");
  SideBySide both(task.task(), *task.plugin);
  for (int step = 0; step < 20; ++step) {
    both.SetSensor(0, Reals{0.5, -1, 0.25, 3, step * 0.1, 1 / 3.0, -0.7, 2, 1e-3});
    both.SetSensor(1, Reals{0.9, 0.1, -0.3, 0.2});
    both.SetSensor(2, Integers{1, 0, step % 2, 0, 0, step % 3 == 0, 0, 1, 0});
    EXPECT_NO_THROW(both.Fire(EventKind::kEndOfTimeStep, 0.005));
  }
}

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
