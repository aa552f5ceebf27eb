// Expressions, computed by compiled plugins and compared with values worked out by hand or by
// <cmath>.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/compiler/emit/compiled_task.h"

namespace compiler {
namespace {

struct Case {
  std::string expression;
  double expected;
};

// One metric for each expression.
void ExpectValues(const std::string& declarations, const std::vector<Case>& cases,
                  const std::map<std::string, std::vector<double>>& senses) {
  std::string text = "task expressions\n" + declarations;
  for (size_t i = 0; i < cases.size(); ++i) {
    text += fmt::format("metric value{} = {}\n", i, cases[i].expression);
  }
  text += "on end_of_time_step { truncate_episode \"done\" }\n";
  CompiledTask task(text);
  Instance instance(task);
  for (const auto& [sensor, values] : senses) instance.Sense(sensor, values);
  instance.Measure();
  for (size_t i = 0; i < cases.size(); ++i) {
    double value = instance.Metric(fmt::format("value{}", i));
    if (std::isnan(cases[i].expected)) {
      EXPECT_TRUE(std::isnan(value)) << cases[i].expression << " gives " << value;
    } else {
      EXPECT_EQ(value, cases[i].expected) << cases[i].expression;
    }
  }
}

TEST(Expressions, FollowTheUsualPrecedence) {
  ExpectValues("sensor a: real\nsensor b: real\nsensor n: int\n",
               {{"a - (b - a)", 4},    // 3 - (2 - 3)
                {"a - b - a", -2},     // (3 - 2) - 3
                {"a / (b * a)", 0.5},  // 3 / 6
                {"a / b * a", 4.5},    // 1.5 * 3
                {"-a - -b", -1},
                {"-(a + b) * b", -10},
                {"a * (b + a)", 15},
                {"n / 2", 3.5},  // no integer division
                {"n * n - 1", 48},
                {"a - -1.5", 4.5}},
               {{"a", {3}}, {"b", {2}}, {"n", {7}}});
}

TEST(Expressions, CountTheElementsOfASet) {
  ExpectValues("sensor f: bool[3]\n",
               {{"count(f)", 2}, {"count(f[0, 1])", 1}, {"count(f[1 .. 2])", 1}},
               {{"f", {1, 0, 1}}});
}

TEST(Expressions, CombineConditions) {
  CompiledTask task(R"(task conditions
sensor a: real
sensor p: bool
sensor q: bool
memory or_of_and: bool = false
memory and_of_or: bool = false
memory not_and: bool = false
memory same: bool = false
memory between: bool = false
on end_of_time_step {
  or_of_and = p or q and p
  and_of_or = (p or q) and q
  not_and = not (p and q)
  same = (a > 1) == (p or q)
  between = a > 1 and not a >= 4 or a != a
  if or_of_and and and_of_or and not_and and same and between { end_episode success "all" }
}
)");
  auto expect = [&](double a, bool p, bool q, const std::vector<bool>& expected) {
    Instance instance(task);
    instance.Sense("a", {a});
    instance.Sense("p", {static_cast<double>(p)});
    instance.Sense("q", {static_cast<double>(q)});
    instance.Fire(TASKC_END_OF_TIME_STEP);
    std::vector<bool> values;
    for (const char* name : {"or_of_and", "and_of_or", "not_and", "same", "between"}) {
      values.push_back(instance.Memory(name) != 0);
    }
    EXPECT_EQ(values, expected) << a << p << q;
  };
  expect(3, true, false, {true, false, true, true, true});
  expect(0, true, true, {true, true, false, false, false});
  expect(4, false, true, {false, true, true, true, false});
  expect(kNan, false, false, {false, false, true, true, true});
}

TEST(Expressions, ComputeWithVectors) {
  ExpectValues("sensor v: vec3 [m]\nsensor w: vec3 [m]\n",
               {{"dot(v, w)", 32},  // 4 + 10 + 18
                {"norm(v - w)", std::sqrt(27.0)},
                {"norm(v.xy)", std::sqrt(5.0)},
                {"cross(v, w).x", -3},  // 2 * 6 - 3 * 5
                {"cross(v, w).y", 6},   // 3 * 4 - 1 * 6
                {"cross(v, w).z", -3},  // 1 * 5 - 2 * 4
                {"dot(cross(v, w), v)", 0},
                {"norm(cross(v + w, v - w))", std::sqrt(36.0 + 144 + 36)},
                {"(2 * v + w / 2).z", 9},  // 6 + 3
                {"(-v).y", -2},
                {"v.zyx.x", 3},
                {"v[2] - w[0]", -1},
                {"dot(v * dot(v, w), w)", 1024},  // 32 * 32
                {"sum(v)", 6},
                {"min(v)", 1},
                {"max(v - w)", -3}},
               {{"v", {1, 2, 3}}, {"w", {4, 5, 6}}});
}

TEST(Expressions, CallTheMathematicalFunctionsOfTheLibrary) {
  ExpectValues("sensor a: real\nsensor b: real\nsensor angle: real [rad]\n",
               {{"exp(a)", std::exp(0.3)},
                {"log(a)", std::log(0.3)},
                {"tanh(a)", std::tanh(0.3)},
                {"sin(angle)", std::sin(0.7)},
                {"cos(angle)", std::cos(0.7)},
                {"atan2(a, b)", std::atan2(0.3, -2.0)},
                {"sqrt(a)", std::sqrt(0.3)},
                {"abs(b)", 2},
                {"min(a, b)", -2},
                {"max(a, b, 5)", 5},
                {"clamp(b, -1, 1)", -1},
                {"clamp(a, -1, 1)", 0.3}},
               {{"a", {0.3}}, {"b", {-2}}, {"angle", {0.7}}});
}

TEST(Expressions, RoundAndChoose) {
  ExpectValues("sensor a: real\nsensor n: int\nsensor c: bool\nsensor v: vec3 [m]\n",
               {{"tan(a * 1 rad)", std::tan(-1.5)},
                {"asin(a / 2) / 1 rad", std::asin(-0.75)},
                {"acos(a / 2) / 1 rad", std::acos(-0.75)},
                {"atan(a) / 1 rad", std::atan(-1.5)},
                {"pow(-a, 0.3)", std::pow(1.5, 0.3)},
                {"floor(a)", -2},
                {"ceil(a)", -1},
                {"round(a)", -2},
                {"sign(a) + sign(n) + sign(0 * n)", 0},
                {"select(c, a, n)", -1.5},
                {"select(not c, v, 2 * v).y", 4},
                {"select(c, 0 m, v.x)", 0},
                {"mean(v)", 2},
                {"vec3(a, n, 1).y", 7},
                {"norm(vec2(3 * n, 4 * n))", 35},
                {"dot(vec4(1, 2, 3, 4).wzyx, vec4(a, a, a, a))", -15}},
               {{"a", {-1.5}}, {"n", {7}}, {"c", {1}}, {"v", {1, 2, 3}}});
}

// Ints wrap around, whatever a compiler knows of absolute values.
TEST(Expressions, TheSmallestIntStaysBelowZero) {
  ExpectValues("sensor n: int\n",
               {{"select(abs(n) <= 0, 1, 0)", 1},
                {"select(max(abs(n), 0) > 0, 1, 0)", 0},
                {"select(abs(n + 1) > 0, 1, 0)", 1}},
               {{"n", {-0x1p63}}});
}

TEST(Expressions, Rotate) {
  // Half a turn about z, a third of one about (1, 1, 1), and a matrix that swaps and scales.
  ExpectValues(
      "sensor half: quat\nsensor third: quat\nsensor scaled: mat3\nsensor v: vec3 [m]\n"
      "sensor zero: vec3\n",
      {{"rotate(half, v).x", -1},
       {"rotate(half, v).y", -2},
       {"rotate(half, v).z", 3},
       {"rotate(third, v).x", 3},
       {"rotate(third, v).y", 1},
       {"rotate(third, v).z", 2},
       {"norm(rotate(inverse(third), rotate(third, v)) - v)", 0},
       {"inverse(quat(0, 0, 0, 2)).z", -0.5},
       {"rotate(scaled, v).x", 2},
       {"rotate(scaled, v).y", 1},
       {"rotate(scaled, v).z", 12},
       {"transpose(scaled)[2, 0]", 0},
       {"transpose(scaled)[0, 2]", 3},
       {"roll(quat(0.5, 0.5, 0.5, 0.5)) / 1 rad", std::atan2(1.0, 0.0)},
       {"yaw(half) / 1 rad", std::atan2(0.0, -1.0)},
       {"pitch(third) / 1 rad", 0},
       {"angle_between(vec3(1, 0, 0), vec3(0, 3, 0)) / 1 rad", std::atan2(3.0, 0.0)},
       {"normalize(v * 0).x", 0},
       {"norm(normalize(zero))", 0},
       {"normalize(vec3(0, 3 m, 4 m)).z", 0.8}},
      {{"half", {0, 0, 0, 1}},
       {"third", {0.5, 0.5, 0.5, 0.5}},
       {"scaled", {0, 1, 0, 1, 0, 0, 3, 0, 3}},
       {"v", {1, 2, 3}},
       {"zero", {0, 0, 0}}});
}

// Not a number must reach the check at the payment, whichever argument it is.
TEST(Expressions, ApplyFunctionsToEachElement) {
  ExpectValues(
      "sensor x: real[3]\nsensor y: real[3]\nsensor n: int[3]\n"
      "sensor v: vec3\n",
      {{"sum(max(x, 0))", 8.5},
       {"max(x, y)[1]", 2},
       {"sum(max(x, y, 4))", 15.5},  // 4 + 4 + 7.5
       {"max(x, y, 4)[2]", 7.5},
       {"sum(clamp(x, y, 1))", 3},  // each raised to y, then lowered to 1
       {"sum(min(n, 3))", 6},
       {"sum(sqrt(x * x))", 9.5},
       {"exp(x)[1]", std::exp(-1.0)},
       {"sum(pow(2 * v / v, v))", 14},  // 2 + 4 + 8
       {"atan2(y, x)[2] / 1 rad", std::atan2(-1.0, 7.5)},
       {"sum(sin(x * 1 rad) - sin(x * 1 rad))", 0},
       {"sum(tolerance(v, 1, 2, 1))", 2 + std::exp(-2.302585092994046)},
       {"wrap(x * 1 rad)[2] / 1 rad", 7.5 - 2 * 3.141592653589793},
       {"sum(round(x / 2))", 4},  // 1, -1, 4
       {"norm(max(v, 2))", std::sqrt(4.0 + 4.0 + 9.0)}},
      {{"x", {1, -1, 7.5}}, {"y", {0.5, 2, -1}}, {"n", {1, 2, 7}}, {"v", {1, 2, 3}}});
}

TEST(Expressions, CompareAndJoinEachElement) {
  ExpectValues(
      "sensor x: real[3]\nsensor c: bool[3]\nsensor d: bool[3]\nsensor v: vec3\n"
      "sensor n: int[3]\n",
      {{"count(x > 1)", 1},
       {"count(x > n)", 1},
       {"count(1 > x)", 1},
       {"count(not c)", 1},
       {"count(c and d)", 1},
       {"count(c or d)", 3},
       {"count(c == d)", 1},
       {"count((x > 1) != c)", 1},
       {"count(c and v.x > 0)", 2},
       {"select(any(not c[0, 2]), 1, 0)", 1},
       {"count(v >= 2)", 2},
       {"sum(select(c, x, 10))", 18.5},  // 1 + 7.5 + 10
       {"sum(select(c, 1, 0))", 2},
       {"count(select(c, d, true))", 2},
       {"select(v.x > 0, x, 2 * x)[2]", -1}},
      {{"x", {1, 7.5, -1}},
       {"c", {1, 1, 0}},
       {"d", {0, 1, 1}},
       {"v", {1, 2, 3}},
       {"n", {1, 2, 7}}});
}

TEST(Expressions, MultiplyQuaternions) {
  ExpectValues("sensor q: quat\nsensor p: quat\n",
               {{"(q * p).w", 1 * 5 - 2 * 6 - 3 * 7 - 4 * 8},
                {"(q * p).x", 1 * 6 + 2 * 5 + 3 * 8 - 4 * 7},
                {"(q * p).y", 1 * 7 - 2 * 8 + 3 * 5 + 4 * 6},
                {"(q * p).z", 1 * 8 + 2 * 7 - 3 * 6 + 4 * 5},
                {"(q * inverse(quat(0, 1, 0, 0))).w", 2},
                {"(q * p * q).w", -60 - 24 - 90 - 96}},  // -60 1 - 12 2 - 30 3 - 24 4
               {{"q", {1, 2, 3, 4}}, {"p", {5, 6, 7, 8}}});
}

TEST(Expressions, KeepWhatIsNotANumber) {
  ExpectValues("sensor a: real\nsensor bad: real\nsensor v: vec3\n",
               {{"min(a, bad)", kNan},
                {"min(bad, a)", kNan},
                {"max(a, bad)", kNan},
                {"max(bad, a)", kNan},
                {"clamp(bad, 0, 1)", kNan},
                {"min(v)", kNan},
                {"max(v)", kNan}},
               {{"a", {1}}, {"bad", {kNan}}, {"v", {1, kNan, 3}}});
}

TEST(Expressions, ReadMatricesRowByRow) {
  ExpectValues("sensor r: mat3\nsensor q: quat\n",
               {{"r[0, 2]", 3}, {"r[1, 0]", 4}, {"r[2, 2]", 9}, {"q.w", 1}, {"q.z", 4}},
               {{"r", {1, 2, 3, 4, 5, 6, 7, 8, 9}}, {"q", {1, 2, 3, 4}}});
}

TEST(Expressions, GoThroughTheVectorsOfAnArray) {
  ExpectValues("sensor p: vec3[2]\nsensor q: quat[2]\nsensor v: vec3\nsensor k: real[2]\n",
               {{"p[1].y", 5},
                {"p.y[1]", 5},
                {"p[1][2]", 6},
                {"q[1].w", 5},
                {"sum(q.w)", 6},
                {"sum(p.z)", 9},
                {"sum(p).z", 9},
                {"mean(p).x", 2.5},
                {"min(p.xz).y", 3},
                {"norm(p - v)[0]", 3},              // (0, 0, 3)
                {"norm(p - v)[1]", std::sqrt(54)},  // (3, 3, 6)
                {"dot(p, v)[1]", 14},
                {"dot(p, p.zyx)[0]", 10},
                {"(p * k)[1].x", 40},
                {"(p / k)[1].x", 0.4},
                {"cross(p, v)[1].x", -12},  // 5 * 0 - 6 * 2
                {"cross(v, p)[1].x", 12},
                {"(2 * p - v)[1].xy.y", 8}},
               {{"p", {1, 2, 3, 4, 5, 6}},
                {"q", {1, 2, 3, 4, 5, 6, 7, 8}},
                {"v", {1, 2, 0}},
                {"k", {0.1, 10}}});
}

// The array has one length for each of its vectors, and each vector has the same bits as it has
// alone.
TEST(Expressions, TurnEachVectorAsIfItWereAlone) {
  std::vector<double> vectors(54);
  for (size_t i = 0; i < vectors.size(); ++i) vectors[i] = std::sin(static_cast<double>(i));
  ExpectValues("sensor p: vec3[18]\nsensor q: quat\nsensor r: mat3\n",
               {{"norm(rotate(q, p)[7] - rotate(q, p[7]))", 0},
                {"norm(rotate(r, p)[17] - rotate(r, p[17]))", 0},
                {"norm(p)[16] - norm(p[16])", 0},
                {"norm(p - p[3])[16] - norm(p[16] - p[3])", 0}},
               {{"p", vectors}, {"q", {0.5, -0.5, 0.5, 0.5}}, {"r", {1, 2, 3, 4, 5, 6, 7, 8, 9}}});
}

// Beyond 32 elements the text has loops.
TEST(Expressions, ComputeWithLongArrays) {
  std::vector<double> values(100);
  std::vector<double> flags(100);
  for (size_t i = 0; i < 100; ++i) values[i] = static_cast<double>(i);
  flags[99] = 1;
  ExpectValues("sensor a: real[100]\nsensor f: bool[100]\n",
               {{"sum(a)", 4950},
                {"sum(a[10 .. 59])", 1725},               // 50 * 34.5
                {"sum(a[10 .. 59] + a[0 .. 49])", 2950},  // and 50 * 24.5
                {"sum(a[0 .. 39, 50 .. 59])", 1325},      // 780 + 545
                {"norm(a)", std::sqrt(328350.0)},         // the sum of the squares
                {"norm(2 * a)", std::sqrt(4 * 328350.0)},
                {"dot(a, a)", 328350},
                {"max(a)", 99},
                {"min(a - 50)", -50},
                {"count(f)", 1},
                {"count(f[0 .. 98])", 0}},
               {{"a", values}, {"f", flags}});
}

TEST(Expressions, AnyAllAndNoneSeeEveryElement) {
  std::string text =
      "task t\nsensor f: bool[3]\nsensor h: bool[50]\n"
      "memory few_any: bool = false\nmemory few_all: bool = false\n"
      "memory few_none: bool = false\nmemory many_any: bool = false\n"
      "memory many_all: bool = false\nmemory many_none: bool = false\n"
      "on end_of_time_step {\n"
      "few_any = any(f)\nfew_all = all(f)\nfew_none = none(f)\n"
      "many_any = any(h)\nmany_all = all(h)\nmany_none = none(h)\n"
      "truncate_episode \"done\" }\n";
  CompiledTask task(text);
  auto expect = [&](std::vector<double> few, std::vector<double> many, bool any, bool all) {
    Instance instance(task);
    instance.Sense("f", few);
    instance.Sense("h", many);
    instance.Fire(TASKC_END_OF_TIME_STEP);
    for (std::string prefix : {"few_", "many_"}) {
      EXPECT_EQ(instance.Memory(prefix + "any"), any);
      EXPECT_EQ(instance.Memory(prefix + "all"), all);
      EXPECT_EQ(instance.Memory(prefix + "none"), !any);
    }
  };
  std::vector<double> last(50);
  last.back() = 1;
  expect({0, 0, 0}, std::vector<double>(50), false, false);
  expect({0, 0, 1}, last, true, false);
  expect({1, 1, 1}, std::vector<double>(50, 1), true, true);
}

}  // namespace
}  // namespace compiler
