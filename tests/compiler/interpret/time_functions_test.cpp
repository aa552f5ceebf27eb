// The functions of the past against values computed by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "compiler/interpret/evaluator.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

constexpr double kHalf = 0.5;  // of a second: a time step

// A task that keeps what an expression is at the end of each step.
class PastRun {
 public:
  explicit PastRun(const std::string& expression, const std::string& type = "real",
                   const std::string& declarations = "")
      : task_(CheckTask("task tested\nsensor x: real\nsensor c: bool\nsensor v: vec2\n" +
                        declarations + "memory seen: " + type + " = " +
                        (type == "bool" ? "false" : "0") + "\nmetric last_seen = select(" +
                        (type == "bool" ? "seen" : "c") +
                        ", 1, 0) + x + v.x\non end_of_time_step { seen = " + expression + " }\n")),
        evaluator_(task_) {}

  void Start(double x) {
    Set("x", {x});
    Set("v", {x, 2 * x});
    evaluator_.Fire(EventKind::kStartOfEpisode, 0);
  }
  double Step(double x) {
    Set("x", {x});
    Set("v", {x, 2 * x});
    return Seen();
  }
  double StepIf(bool condition) {
    SetFlag(condition);
    return Seen();
  }
  void StartIf(bool condition) {
    SetFlag(condition);
    evaluator_.Fire(EventKind::kStartOfEpisode, 0);
  }
  std::vector<double> Steps(const std::vector<double>& xs) {
    std::vector<double> seen;
    for (const double x : xs) seen.push_back(Step(x));
    return seen;
  }
  std::vector<double> StepsIf(const std::vector<bool>& conditions) {
    std::vector<double> seen;
    for (const bool condition : conditions) seen.push_back(StepIf(condition));
    return seen;
  }
  const CheckedTask& task() const { return task_; }

 private:
  double Seen() {
    evaluator_.Fire(EventKind::kEndOfTimeStep, kHalf);
    for (size_t i = 0; i < task_.memory.size(); ++i)
      if (task_.memory[i].name == "seen") return RealOf(evaluator_.frame().memory[i]);
    return NAN;
  }
  void Set(const std::string& sensor, const Reals& value) {
    for (size_t i = 0; i < task_.sensors.size(); ++i)
      if (task_.sensors[i].name == sensor) evaluator_.frame().sensors[i] = value;
  }
  void SetFlag(bool value) {
    for (size_t i = 0; i < task_.sensors.size(); ++i)
      if (task_.sensors[i].name == "c") evaluator_.frame().sensors[i] = Integers{value};
  }

  CheckedTask task_;
  Evaluator evaluator_;
};

TEST(Past, PreviousAndChange) {
  PastRun previous("previous(x)");
  previous.Start(3);
  EXPECT_THAT(previous.Steps({4, 6, 5}), ElementsAre(3, 4, 6));
  PastRun change("change(x)");
  change.Start(3);
  EXPECT_THAT(change.Steps({4, 6, 5}), ElementsAre(1, 2, -1));
  PastRun rate("rate(x) * 1 s");
  rate.Start(3);
  EXPECT_THAT(rate.Steps({4, 6, 5}), ElementsAre(2, 4, -2));
}

TEST(Past, Delay) {
  PastRun steps("delay(x, 2)");
  steps.Start(1);
  EXPECT_THAT(steps.Steps({2, 3, 4, 5, 6}), ElementsAre(1, 1, 2, 3, 4));
  PastRun none("delay(x, 0)");
  none.Start(1);
  EXPECT_THAT(none.Steps({2, 3}), ElementsAre(2, 3));
}

TEST(Past, ADelayFollowsItsParamUpToItsRange) {
  PastRun run("delay(x, lag)", "real", "param lag: int = 1 in 0 .. 3\n");
  run.Start(1);
  EXPECT_THAT(run.Steps({2, 3}), ElementsAre(1, 2));
}

// In each step (1 - exp(-0.5 / 2)) of the way.
TEST(Past, Smooth) {
  PastRun run("smooth(x, 2 s)");
  run.Start(1);
  const double share = 1 - std::exp(-0.25);
  const double first = 1 + (5 - 1) * share;
  EXPECT_DOUBLE_EQ(run.Step(5), first);
  EXPECT_DOUBLE_EQ(run.Step(0), first + (0 - first) * share);
  PastRun at_once("smooth(x, 0 s)");
  at_once.Start(1);
  EXPECT_THAT(at_once.Steps({5, 7}), ElementsAre(5, 7));
}

TEST(Past, Held) {
  PastRun run("held(c, 1 s)", "bool");
  run.StartIf(true);
  EXPECT_THAT(run.StepsIf({true, true, true, false, true, true, true}),
              ElementsAre(0, 1, 1, 0, 0, 1, 1));
}

TEST(Past, Since) {
  PastRun run("since(c) / 1 s");
  run.StartIf(false);
  EXPECT_THAT(run.StepsIf({false, false, true, false, false}), ElementsAre(0.5, 1, 0, 0.5, 1));
}

TEST(Past, RisingAndFalling) {
  PastRun rising("rising(c)", "bool");
  rising.StartIf(true);
  EXPECT_THAT(rising.StepsIf({true, false, true, true}), ElementsAre(0, 0, 1, 0));
  PastRun falling("falling(c)", "bool");
  falling.StartIf(true);
  EXPECT_THAT(falling.StepsIf({true, false, false, true}), ElementsAre(0, 1, 0, 0));
}

TEST(Past, WorksOnEachElement) {
  PastRun run("change(v).y + delay(v, 1).x");
  run.Start(1);
  EXPECT_THAT(run.Steps({2, 4}), ElementsAre(2 + 1, 4 + 2));
}

TEST(Past, OfThePastIsComputedInsideOut) {
  PastRun run("change(change(x))");
  run.Start(0);
  EXPECT_THAT(run.Steps({1, 4, 9}), ElementsAre(1, 2, 2));
}

TEST(Past, IsComputedInBranchesThatDoNotRun) {
  PastRun run("select(x > 2, previous(x), -1.0)");
  run.Start(0);
  EXPECT_THAT(run.Steps({1, 2, 3}), ElementsAre(-1, -1, 2));
}

TEST(Past, OfTheSameIsRememberedOnce) {
  EXPECT_EQ(PastRun("change(x) + change(x) + change(2 * x)").task().time_functions.size(), 2u);
}

TEST(Past, StartsAnewWithTheEpisode) {
  PastRun run("change(x) + smooth(x, 5 s) + delay(x, 1)");
  run.Start(0);
  run.Steps({1, 2, 3});
  run.Start(7);
  EXPECT_EQ(run.Step(7), 0 + 7 + 7);
}

}  // namespace
}  // namespace compiler
