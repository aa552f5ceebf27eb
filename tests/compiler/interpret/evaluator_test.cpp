// The meaning of tasks, without building them.
#include "compiler/interpret/evaluator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::ElementsAre;

constexpr double kStep = 0.005;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A task of its own with some sensors, and what its events do.
class Evaluation {
 public:
  explicit Evaluation(const std::string& text)
      : task_(CheckTask("task tested\n"
                        "sensor x: real\nsensor v: vec3\nsensor turn: mat3\nsensor n: int\n"
                        "sensor touch: bool[4]\n" +
                        text)),
        evaluator_(task_) {}

  void Sense(const std::string& name, Value value) {
    for (size_t i = 0; i < task_.sensors.size(); ++i) {
      if (task_.sensors[i].name == name) evaluator_.frame().sensors[i] = std::move(value);
    }
  }
  void Step(EventKind event = EventKind::kEndOfTimeStep) { evaluator_.Fire(event, kStep); }
  const Value& Memory(const std::string& name) const {
    for (size_t i = 0; i < task_.memory.size(); ++i) {
      if (task_.memory[i].name == name) return evaluator_.frame().memory[i];
    }
    throw std::runtime_error("no memory " + name);
  }
  Reals MemoryReals(const std::string& name) const { return ToReals(Memory(name)); }
  Frame& frame() { return evaluator_.frame(); }
  Evaluator& evaluator() { return evaluator_; }

 private:
  CheckedTask task_;
  Evaluator evaluator_;
};

// The value of an expression over the sensors of Evaluation.
Reals ValueOfText(const std::string& type, const std::string& expression) {
  Evaluation run("memory result: " + type + " = " + (type.starts_with("bool") ? "false" : "0") +
                 "\non end_of_time_step { result = " + expression + " }\n");
  run.Sense("x", Reals{0.5});
  run.Sense("v", Reals{1, -2, 4});
  run.Sense("turn", Reals{1, 2, 3, 4, 5, 6, 7, 8, 9});
  run.Sense("n", Integers{7});
  run.Sense("touch", Integers{0, 1, 1, 0});
  run.Step();
  return run.MemoryReals("result");
}

TEST(Evaluator, CalculatesElementByElement) {
  EXPECT_THAT(ValueOfText("vec3", "2 * v + v.zyx"), ElementsAre(6, -6, 9));
  EXPECT_THAT(ValueOfText("vec3", "-v / x"), ElementsAre(-2, 4, -8));
  EXPECT_THAT(ValueOfText("mat3", "turn - x"),
              ElementsAre(0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5));
  EXPECT_THAT(ValueOfText("vec3", "abs(v)"), ElementsAre(1, 2, 4));
  EXPECT_THAT(ValueOfText("real", "turn[1, 2]"), ElementsAre(6));
  EXPECT_THAT(ValueOfText("bool[4]", "touch"), ElementsAre(0, 1, 1, 0));
}

TEST(Evaluator, ReducesFromTheLeft) {
  EXPECT_THAT(ValueOfText("real", "sum(v)"), ElementsAre(3));
  EXPECT_THAT(ValueOfText("real", "norm(v.xy)"), ElementsAre(std::sqrt(5.0)));
  EXPECT_THAT(ValueOfText("real", "dot(v, v.yzx)"), ElementsAre(-2 - 8 + 4));
  EXPECT_THAT(ValueOfText("vec3", "cross(v, v.yzx)"), ElementsAre(-2 - 16, -8 - 1, 4 - 4));
  EXPECT_THAT(ValueOfText("real", "min(v)"), ElementsAre(-2));
  EXPECT_THAT(ValueOfText("real", "max(x, 0.25, 0.75)"), ElementsAre(0.75));
  EXPECT_THAT(ValueOfText("int", "count(touch)"), ElementsAre(2));
  EXPECT_THAT(ValueOfText("bool", "none(touch)"), ElementsAre(0));
  EXPECT_THAT(ValueOfText("bool", "none(touch[0, 3])"), ElementsAre(1));
  EXPECT_THAT(ValueOfText("bool", "all(touch[1..2])"), ElementsAre(1));
  EXPECT_THAT(ValueOfText("bool", "any(touch) and not all(touch)"), ElementsAre(1));
}

TEST(Evaluator, CallsFunctions) {
  EXPECT_THAT(ValueOfText("real", "clamp(v.z, -1, 2.5)"), ElementsAre(2.5));
  EXPECT_THAT(ValueOfText("int", "clamp(n, 1, 5)"), ElementsAre(5));
  EXPECT_THAT(ValueOfText("real", "exp(x)"), ElementsAre(std::exp(0.5)));
  EXPECT_THAT(ValueOfText("real", "atan2(v.y, v.x) / 1 rad"), ElementsAre(std::atan2(-2.0, 1.0)));
}

TEST(Evaluator, MakesRealsOfInts) {
  EXPECT_THAT(ValueOfText("real", "n / 2"), ElementsAre(3.5));
  EXPECT_THAT(ValueOfText("real", "n * x"), ElementsAre(3.5));
  EXPECT_THAT(ValueOfText("bool", "n > x"), ElementsAre(1));
  EXPECT_THAT(ValueOfText("bool", "n == 7"), ElementsAre(1));
}

TEST(Evaluator, LetsIntsWrapAround) {
  Evaluation run(
      "memory big: int = 0\nmemory least: int = 0\n"
      "on end_of_time_step { big = n + n  least = abs(n + 1) }\n");
  constexpr int64_t kLargest = std::numeric_limits<int64_t>::max();
  run.Sense("n", Integers{kLargest});
  run.Step();
  EXPECT_EQ(std::get<Integers>(run.Memory("big")).front(), -2);
  EXPECT_EQ(std::get<Integers>(run.Memory("least")).front(), -kLargest - 1);
}

TEST(Evaluator, LetsNoMistakeGetLost) {
  Evaluation run(
      "memory low: real = 0\nmemory high: real = 0\n"
      "on end_of_time_step { low = min(x, 1)  high = max(1, x) }\n");
  run.Sense("x", Reals{kNan});
  run.Step();
  EXPECT_TRUE(std::isnan(run.MemoryReals("low").front()));
  EXPECT_TRUE(std::isnan(run.MemoryReals("high").front()));
}

TEST(Evaluator, PaysTermsAndRates) {
  Evaluation run(
      "memory seen: real = 0\non end_of_time_step {\n"
      "  reward once = 3\n  seen = reward\n  reward rate often = 2 * x\n}\n");
  run.Sense("x", Reals{0.5});
  run.Step();
  run.Step();
  EXPECT_EQ(run.frame().reward, 3 + 1 * kStep);
  EXPECT_THAT(run.frame().terms, ElementsAre(6, 2 * kStep));
  EXPECT_THAT(run.MemoryReals("seen"), ElementsAre(3));
}

TEST(Evaluator, DoesNotPayWhatIsNotFinite) {
  Evaluation run(
      "on end_of_time_step { reward one = 1  reward bad = 1 / x  reward more = 1 / x }\n");
  run.Sense("x", Reals{0});
  run.Step();
  EXPECT_EQ(run.frame().reward, 1);
  EXPECT_EQ(run.frame().fault, 1);
  run.Sense("x", Reals{1});
  run.Step();
  EXPECT_EQ(run.frame().reward, 3);
  EXPECT_EQ(run.frame().fault, -1);
}

TEST(Evaluator, DoesNotPayWhatMakesTheRewardTooLarge) {
  Evaluation run(
      "on end_of_time_step { reward one = 1e30  reward bad = 1e29  reward more = -1 }\n");
  run.Step();
  EXPECT_EQ(run.frame().reward, 1e30 - 1);
  EXPECT_EQ(run.frame().fault, 1);
  EXPECT_THAT(run.frame().terms, ElementsAre(1e30, 0, -1));
}

TEST(Evaluator, TakesTheFirstBranchThatHolds) {
  Evaluation run(
      "memory branch: int = 0\non end_of_time_step {\n"
      "  if x > 1 { branch = 1 } else if x > 0 { branch = 2 } else { branch = 3 }\n}\n");
  const auto branch = [&](double x) {
    run.Sense("x", Reals{x});
    run.Step();
    return run.MemoryReals("branch").front();
  };
  EXPECT_EQ(branch(2), 1);
  EXPECT_EQ(branch(0.5), 2);
  EXPECT_EQ(branch(kNan), 3);
}

TEST(Evaluator, EndsForTheFirstReason) {
  Evaluation run(
      "after_end continue\n"
      "on end_of_time_step {\n  if x > 0 { truncate_episode \"a\" }\n"
      "  if x != 0 { end_episode failure \"b\" }\n}\n");
  run.Step();
  EXPECT_EQ(run.frame().end, -1);
  run.Sense("x", Reals{-1});
  run.Step();
  EXPECT_EQ(run.frame().end, 1);
  run.Sense("x", Reals{1});
  run.Step();
  EXPECT_EQ(run.frame().end, 0);
  EXPECT_EQ(run.frame().first_end, 1);
}

// Pays beside an end.
constexpr const char* kEnding =
    "memory steps: int = 0\nmemory actions: int = 0 per action\n"
    "on start_of_action { actions += 1 }\n"
    "on end_of_time_step {\n  steps += 1\n  reward rate all = 200\n"
    "  if x > 0 { reward fall = -2 end_episode failure \"falls\" }\n"
    "  require x < 5\n  reward behind = 1\n}\n"
    "on end_of_episode { reward last = 3 }\n";

TEST(Evaluator, DoesNothingAfterAnEndButWhatEpisodesBeginAndEndWith) {
  Evaluation run(kEnding);
  run.Step();
  run.Sense("x", Reals{1});
  run.Step(EventKind::kStartOfAction);
  for (int i = 0; i < 3; ++i) run.Step();
  EXPECT_EQ(run.frame().end, -1);
  EXPECT_EQ(run.frame().reward, 0);
  run.Step(EventKind::kStartOfAction);
  EXPECT_THAT(run.frame().terms, ElementsAre(2, -2, 2, 0));
  EXPECT_THAT(run.MemoryReals("steps"), ElementsAre(2));
  EXPECT_THAT(run.MemoryReals("actions"), ElementsAre(1));
  run.Step(EventKind::kEndOfEpisode);
  EXPECT_THAT(run.frame().terms, ElementsAre(2, -2, 2, 3));
  run.Step(EventKind::kStartOfEpisode);
  run.Step();
  EXPECT_THAT(run.frame().terms, ElementsAre(3, -4, 3, 3));
}

TEST(Evaluator, DoesNothingAfterARequirementThatDoesNotHold) {
  Evaluation run("on end_of_time_step {\n  require x < 5\n  reward a = 1\n}\n");
  run.Sense("x", Reals{6});
  for (int i = 0; i < 3; ++i) run.Step();
  EXPECT_THAT(run.frame().terms, ElementsAre(1));
  EXPECT_EQ(run.frame().first_violation, 0);
}

TEST(Evaluator, GoesOnAfterAnEndWhereTheTaskSaysSo) {
  Evaluation run(std::string("after_end continue\n") + kEnding);
  run.Sense("x", Reals{1});
  for (int i = 0; i < 3; ++i) run.Step();
  EXPECT_THAT(run.frame().terms, ElementsAre(3, -6, 3, 0));
  EXPECT_EQ(run.frame().end, 0);
}

TEST(Evaluator, ResetsMemoryAsItsScopeSays) {
  Evaluation run(
      "param begin: real = 3\n"
      "memory run: real = begin per run\nmemory episode: real = begin\n"
      "memory action: vec2 = begin per action\n"
      "on end_of_time_step { run += 1  episode += 1  action += 1 }\n");
  run.Step();
  EXPECT_THAT(run.MemoryReals("action"), ElementsAre(4, 4));
  run.frame().params[0] = 5;
  run.Step(EventKind::kStartOfAction);
  EXPECT_THAT(run.MemoryReals("action"), ElementsAre(5, 5));
  EXPECT_THAT(run.MemoryReals("episode"), ElementsAre(4));
  run.Step(EventKind::kStartOfEpisode);
  EXPECT_THAT(run.MemoryReals("episode"), ElementsAre(5));
  EXPECT_THAT(run.MemoryReals("run"), ElementsAre(4));
  run.evaluator().Initialize();
  EXPECT_THAT(run.MemoryReals("run"), ElementsAre(5));
}

TEST(Evaluator, ComputesAValueBeforeItIsStored) {
  Evaluation run("memory p: vec3 = 0\non end_of_time_step { p += v  p = p.yzx  p *= p.x }\n");
  run.Sense("v", Reals{1, 2, 3});
  run.Step();
  EXPECT_THAT(run.MemoryReals("p"), ElementsAre(4, 6, 2));
}

TEST(Evaluator, Measures) {
  Evaluation run("metric max height = v.z * 2\nmetric steps = n\n");
  run.Sense("v", Reals{0, 0, 3});
  run.Sense("n", Integers{4});
  run.evaluator().Measure();
  EXPECT_THAT(run.frame().metrics, ElementsAre(6, 4));
}

}  // namespace
}  // namespace compiler
