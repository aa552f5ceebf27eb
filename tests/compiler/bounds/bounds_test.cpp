#include "compiler/bounds/bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/compiler/bounds/expect_ends.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

// The bounds of a task with two sensors, `x` and `y`, plain numbers from -1 to 1, a third without
// range, `free`, and a condition, `down`.
TaskBounds BoundsOf(const std::string& declarations, const std::string& block) {
  CheckedTask task = CheckTask(
      "task tested\nsensor x: real\nsensor y: real\nsensor free: real\nsensor down: bool\n" +
      declarations + "\non end_of_time_step {\n" + block + "\n}\n");
  for (CheckedSensor& sensor : task.sensors) {
    if (sensor.name != "x" && sensor.name != "y") continue;
    sensor.minimum = {-1};
    sensor.maximum = {1};
  }
  return ComputeBounds(task);
}

// The bounds of `expression`, paid as a rate.
Interval RateOf(const std::string& expression, const std::string& declarations = "") {
  return BoundsOf(declarations, "reward rate tested = " + expression).terms[0].rate.value();
}

TEST(Bounds, OfATermComeFromTheSensors) {
  ExpectEnds(RateOf("2 * x + y"), -3, 3);
  ExpectEnds(RateOf("abs(x) - x * x"), -1, 1);
  ExpectEnds(RateOf("-tanh(free)"), -1, 1);
  ExpectEnds(RateOf("gain * x", "param gain: real = 2 in 1 .. 5"), -5, 5);
}

TEST(Bounds, OfSquaresAreNeverNegative) {
  ExpectEnds(RateOf("exp(-x * x)"), std::exp(-1), 1);
  ExpectEnds(RateOf("exp(-(free * free))"), 0, 1);
  ExpectEnds(RateOf("sum(v * v)", "sensor v: vec3 in -2 .. 1"), 0, 12);
  ExpectEnds(RateOf("max(-a * a)", "sensor a: real[4] in -2 .. 1"), -4, 0);
  ExpectEnds(RateOf("-y * x"), -1, 1);
}

TEST(Bounds, OfChoicesAndVectorsAreThoseOfTheirParts) {
  ExpectEnds(RateOf("select(x > y, 2 * x, -3.0)"), -3, 2);
  ExpectEnds(RateOf("select(true, 2 * x, -3.0)"), -2, 2);
  ExpectEnds(RateOf("sum(vec3(x, 2 * y, 1.0))"), -2, 4);
  ExpectEnds(RateOf("floor(1.5 * x) + sign(free)"), -3, 2);
}

TEST(Bounds, OfGoalsAreThoseOfWhatTheyAreDrawnFrom) {
  ExpectEnds(RateOf("aim", "goal aim: real = uniform(2, 3)"), 2, 3);
  ExpectEnds(RateOf("aim", "goal aim: real = 10 + choose(1, -4, 2)"), 6, 12);
  ExpectEnds(RateOf("aim", "param p: real = 1 in 0 .. 2\ngoal aim: real = uniform(-p, p) per 2 s"),
             -2, 2);
  ExpectEnds(RateOf("v.y", "goal v: vec2 = uniform(1, 2)"), 1, 2);
  ExpectEnds(RateOf("aim", "goal aim: real = normal(1, 2)"), 1 - 2 * 8.572, 1 + 2 * 8.572);
  ExpectEnds(RateOf("1 / aim", "goal aim: real = uniform(2, 4)"), 0.25, 0.5);
}

TEST(Bounds, OfObservationsAreThoseOfAllTheirElements) {
  const TaskBounds bounds = BoundsOf(
      "observe 2 * x\nobserve pair = vec2(x, 3.0)\nobserve down\nobserve free\n"
      "memory n: int = 0\nobserve n",
      "reward rate a = x\nif n < 5 { n += 1 }");
  ASSERT_EQ(bounds.observations.size(), 5u);
  ExpectEnds(bounds.observations[0].value, -2, 2);
  ExpectEnds(bounds.observations[1].value, -1, 3);
  ExpectEnds(bounds.observations[2].value, 0, 1);
  EXPECT_FALSE(IsBounded(bounds.observations[3].value));
  EXPECT_EQ(bounds.observations[3].causes.size(), 1u);
  ExpectEnds(bounds.observations[4].value, 0, 5);
}

TEST(Bounds, OfArraysOfVectorsAreThoseOfTheirVectors) {
  const std::string sensors = "sensor few: vec3[3] in -1 .. 2\nsensor many: vec3[30] in -1 .. 2";
  for (const std::string array : {"few", "many"}) {
    ExpectEnds(RateOf("max(" + array + ".z)", sensors), -1, 2);
    ExpectEnds(RateOf("sum(" + array + "[0, 1]).z", sensors), -2, 4);
    ExpectEnds(RateOf("min(norm(2 * " + array + ".xy))", sensors), 0, std::sqrt(32.0));
  }
  ExpectEnds(RateOf("max(dot(few, vec3(1, -1, 0)))", sensors), -3, 3);
}

TEST(Bounds, OfADirectionAreThoseOfItsLength) {
  ExpectEnds(RateOf("normalize(v).y", "sensor v: vec3"), -1, 1);
  ExpectEnds(RateOf("max(normalize(few - 1))", "sensor few: real[3]"), -1, 1);
}

TEST(Bounds, OfThePastAreThoseOfItsArgument) {
  ExpectEnds(RateOf("smooth(x + 2, 0.1 s)"), 1, 3);
  ExpectEnds(RateOf("previous(x) + delay(x, 3)"), -2, 2);
  ExpectEnds(RateOf("change(x)"), -2, 2);
  ExpectEnds(RateOf("since(down) / 1 s"), 0, kInfinity);
  ExpectEnds(RateOf("select(held(down, 1 s), 2.0, 3.0)"), 2, 3);
  ExpectEnds(RateOf("1 / smooth(x + 3, 0.1 s)"), 0.25, 0.5);
}

TEST(Bounds, OfTheTimeInAPhaseEndAtItsLimit) {
  const auto bounds = [](const std::string& limit) {
    return *BoundsOf(
                "on start_of_time_step { reward a = phase_time / 1 s }\n"
                "phase reach within 3 s else lift { }\nphase lift " +
                    limit + "{ if down { next reach } }\n",
                "")
                .terms[0]
                .payment;
  };
  ExpectEnds(bounds("within 5 s else reach "), 0, 5);
  ExpectEnds(bounds(""), 0, kInfinity);
}

TEST(Bounds, OfAPotentialCoverAnyDiscountAndEnd) {
  const TaskBounds bounds = BoundsOf("reward potential near = 2 * x - 3", "");
  ExpectEnds(bounds.terms[0].potential.value(), -5, -1);
  EXPECT_FALSE(bounds.terms[0].rate || bounds.terms[0].payment);
  ExpectEnds(PaymentOfPotential({-5, -1}), -4, 5);
  ExpectEnds(PaymentOfPotential({1, 5}), -5, 4);
  ExpectEnds(PaymentOfPotential({-1, 2}), -3, 3);
}

TEST(Bounds, OfATermCoverAllItsStatements) {
  const TaskBounds bounds =
      BoundsOf("", "if down { reward rate a = x } else { reward rate a = 3 }\nreward a = -2 + y");
  ExpectEnds(*bounds.terms[0].rate, -1, 3);
  ExpectEnds(*bounds.terms[0].payment, -3, -1);
}

TEST(Bounds, AreNarrowedByConditions) {
  const auto inside = [](const std::string& condition, const std::string& value) {
    return BoundsOf("param p: real = 0 in -1 .. 1",
                    "let z = x\nif " + condition + " { reward rate tested = " + value + " }")
        .terms[0]
        .rate.value_or(kNothing);
  };
  ExpectEnds(inside("x >= 0.5", "x"), 0.5, 1);
  ExpectEnds(inside("x >= 0.5 and x <= 0.75", "x"), 0.5, 0.75);
  ExpectEnds(inside("not (x < 0.5 or x > 0.75)", "x"), 0.5, 0.75);
  ExpectEnds(inside("abs(x) <= 0.5", "x"), -0.5, 0.5);
  ExpectEnds(inside("z >= 0.5", "x"), 0.5, 1);
  ExpectEnds(inside("x >= y and y >= 0.5", "x - y"), -0.5, 0.5);
  ExpectEnds(inside("p >= 0.5", "p"), 0.5, 1);
  ExpectEnds(inside("max(x, y) <= 0.25", "x + y"), -2, 0.5);
  ExpectEnds(inside("x >= 0.5 or x <= -0.5", "abs(x)"), 0, 1);
  EXPECT_NEAR(inside("2 * x + 1 <= 2", "x").high, 0.5, 1e-12);
}

TEST(Bounds, AreNarrowedByConditionsOnEachElement) {
  const auto inside = [](const std::string& condition, const std::string& value) {
    return BoundsOf("sensor few: real[3] in -1 .. 1\nsensor c: bool[3]",
                    "if " + condition + " { reward rate tested = " + value + " }")
        .terms[0]
        .rate.value_or(kNothing);
  };
  ExpectEnds(inside("all(few >= 0.5)", "few[1]"), 0.5, 1);
  ExpectEnds(inside("none(few > 0.5 or few < 0)", "few[1]"), 0, 0.5);
  ExpectEnds(inside("all(c and few >= 0.5)", "few[1]"), 0.5, 1);
  ExpectEnds(inside("not any(not (few >= 0.5))", "few[2]"), 0.5, 1);
  ExpectEnds(inside("any(few >= 0.5)", "few[2]"), -1, 1);
  ExpectEnds(inside("x >= 0.25 and all(few >= x)", "few[0]"), 0.25, 1);
  ExpectEnds(inside("all(not c)", "count(c)"), 0, 0);
}

TEST(Bounds, OfFunctionsOfEachElement) {
  const std::string sensors = "sensor few: real[3] in -1 .. 2\nsensor c: bool[3]";
  ExpectEnds(RateOf("sum(max(few, 0))", sensors), 0, 6);
  ExpectEnds(RateOf("sum(clamp(few, -0.5, 1))", sensors), -1.5, 3);
  ExpectEnds(RateOf("sum(select(c, 1, few))", sensors), -3, 6);
  ExpectEnds(RateOf("count(few > 3)", sensors), 0, 0);
  ExpectEnds(RateOf("count(few >= -1 and c)", sensors), 0, 3);
}

TEST(Bounds, OfABranchWithAContradictionAreNone) {
  const TaskBounds bounds = BoundsOf("", R"(
    if x > 0.5 and x < 0.25 { reward rate never = 1 end_episode failure "never" }
    if x > 2 { reward rate never = 1 }
    if down {
      if not down { reward rate never = 1 }
    }
    if y < 0 { end_episode failure "sometimes" })");
  EXPECT_FALSE(bounds.terms[0].rate);
  EXPECT_EQ(bounds.ends_reached, (std::vector<bool>{false, true}));
}

TEST(Bounds, OfElseAreWhatIsLeft) {
  const TaskBounds bounds = BoundsOf("", R"(
    if x < 0 { reward rate a = 0 }
    else if x < 0.5 { reward rate b = x }
    else { reward rate c = x })");
  EXPECT_DOUBLE_EQ(bounds.terms[1].rate->low, 0);
  EXPECT_LT(bounds.terms[1].rate->high, 0.5);
  ExpectEnds(*bounds.terms[2].rate, 0.5, 1);
}

TEST(Bounds, OfFlagsStayExact) {
  const TaskBounds bounds = BoundsOf("memory fallen: bool = false per action", R"(
    if down and not fallen {
      fallen = true
      reward fall = -2
    })");
  EXPECT_EQ(bounds.memory[0][0], kAnyBool);
  ExpectEnds(*bounds.terms[0].payment, -2, -2);
}

TEST(Bounds, OfACounterEndWhereItIsHeld) {
  const TaskBounds bounds = BoundsOf("memory n: int = 0\nmemory a: real = 0", R"(
    if n < 10 { n += 1 }
    if a < 10 { a += 0.25 * abs(x) }
    reward rate sum = n + a)");
  ExpectEnds(bounds.memory[0][0], 0, 10);
  EXPECT_EQ(bounds.memory[1][0].low, 0);
  EXPECT_NEAR(bounds.memory[1][0].high, 10.25, 0.001);
}

TEST(Bounds, OfASumAreInfinite) {
  const TaskBounds bounds =
      BoundsOf("memory n: int = 0\nmemory a: real = 0\nmetric shown = a",
               "n += 1\na += x\nreward rate a = n\nreward rate b = a\nif a < -40 { n = 0 }");
  ExpectEnds(bounds.memory[0][0], 0, kInfinity);
  ExpectEnds(bounds.memory[1][0], -kInfinity, kInfinity);
  ASSERT_EQ(bounds.terms[0].causes.size(), 1u);
  EXPECT_EQ(bounds.terms[0].causes[0].kind, Cause::kMemory);
  EXPECT_EQ(bounds.terms[0].causes[0].name, "n");
  EXPECT_EQ(bounds.metrics[0].causes[0].name, "a");
}

TEST(Bounds, OfWhatWasSensedBeforeAreThoseOfTheSensor) {
  const TaskBounds bounds = BoundsOf("memory before: real = 0", R"(
    reward progress = x - before
    before = x)");
  ExpectEnds(bounds.memory[0][0], -1, 1);
  ExpectEnds(*bounds.terms[0].payment, -2, 2);
}

TEST(Bounds, TellWhatHasNone) {
  const auto cause = [](const std::string& expression) {
    const TaskBounds bounds = BoundsOf("param p: real = 0", "reward rate tested = " + expression);
    return bounds.terms[0].causes.empty() ? "none" : bounds.terms[0].causes[0].name;
  };
  EXPECT_EQ(cause("x * free"), "free");
  EXPECT_EQ(cause("tanh(free) * p"), "p");
  EXPECT_EQ(cause("1 / x"), "a division by what may be 0");
  EXPECT_EQ(cause("log(x + 1)"), "`log`");
  EXPECT_EQ(cause("min(free, 1)"), "free");
  EXPECT_EQ(cause("tanh(free)"), "none");
  // A cause that is met twice is still the only one.
  const TaskBounds bounds = BoundsOf("", "reward rate tested = free * (x + free)");
  EXPECT_EQ(bounds.terms[0].causes.size(), 1u);
}

TEST(Bounds, OfTheRewardSoFarAreThoseOfItsTerms) {
  const TaskBounds bounds = BoundsOf("", R"(
    reward a = x
    if down { reward b = 2 }
    reward c = 10 * reward)");
  ExpectEnds(*bounds.terms[2].payment, -10, 30);
}

}  // namespace
}  // namespace compiler
