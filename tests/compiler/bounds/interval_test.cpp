#include "compiler/bounds/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "compiler/bounds/functions.h"
#include "tests/compiler/bounds/expect_ends.h"

namespace compiler {
namespace {

using enum BinaryOperator;

Interval Calculate(BinaryOperator op, const Interval& left, const Interval& right) {
  return Calculate(op, left, right, Scalar::kReal);
}

TEST(Interval, OfAProductComesFromTheEnds) {
  ExpectEnds(Calculate(kMultiply, {-2, 3}, {-5, 4}), -15, 12);
  ExpectEnds(Calculate(kSubtract, {0, 1}, {0, 1}), -1, 1);
}

TEST(Interval, OfAnInfinityAndAnyNumberIsThatInfinity) {
  const Interval infinity{kInfinity, kInfinity, true};
  const Interval sum = Calculate(kAdd, infinity, Interval{});
  EXPECT_EQ(sum.low, kInfinity);
  EXPECT_EQ(sum.high, kInfinity);
  const Interval difference = Calculate(kSubtract, Interval{}, infinity);
  EXPECT_EQ(difference.low, -kInfinity);
  EXPECT_EQ(difference.high, -kInfinity);
}

TEST(Interval, WithoutEndTimesZeroIsZero) {
  ExpectEnds(Calculate(kMultiply, Interval{}, Exactly(0)), 0, 0);
}

TEST(Interval, OfASquareIsNotNegative) { ExpectEnds(Square({-2, 3}), 0, 9); }

TEST(Interval, DividedByWhatMayBeZeroIsAnything) {
  const Interval quotient = Calculate(kDivide, {1, 2}, {0, 1});
  EXPECT_FALSE(IsBounded(quotient));
  EXPECT_TRUE(quotient.may_be_infinite);
  EXPECT_FALSE(quotient.may_be_nan);
  EXPECT_TRUE(Calculate(kDivide, {0, 2}, {0, 1}).may_be_nan);
  ExpectEnds(Calculate(kDivide, {-1, 2}, {0.5, 1}), -2, 4);
}

TEST(Interval, OfAnIntegerThatMayWrapAroundIsAnything) {
  const Interval large{0, 4e18};
  EXPECT_EQ(Calculate(kAdd, large, large, Scalar::kInt), AnyOf(Scalar::kInt));
  EXPECT_EQ(Calculate(kMultiply, {0, kInfinity}, Exactly(2), Scalar::kInt), AnyOf(Scalar::kInt));
  ExpectEnds(Calculate(kAdd, {0, kInfinity}, Exactly(1), Scalar::kInt), 1, kInfinity);
}

TEST(Interval, OfAComparisonIsKnownWhereTheRangesAreApart) {
  EXPECT_EQ(Calculate(kLess, {0, 1}, {2, 3}), Exactly(1));
  EXPECT_EQ(Calculate(kLess, {0, 2}, {2, 3}), kAnyBool);
  EXPECT_EQ(Calculate(kLessEqual, {0, 2}, {2, 3}), Exactly(1));
  EXPECT_EQ(Calculate(kEqual, {0, 1}, {2, 3}), Exactly(0));
  EXPECT_EQ(Calculate(kNotEqual, {0, 1}, {2, 3}), Exactly(1));
  Interval with_nan{0, 1};
  with_nan.may_be_nan = true;
  EXPECT_EQ(Calculate(kLess, with_nan, {2, 3}), kAnyBool);
}

TEST(Interval, OfATangentIsKnownBetweenItsPoles) {
  EXPECT_NEAR(Tan({-1, 1}).high, std::tan(1.0), 1e-12);
  EXPECT_FALSE(IsBounded(Tan({1, 2})));
}

TEST(Interval, OfAnEvenPowerIsNotNegative) {
  EXPECT_NEAR(Pow({-2, 1}, Exactly(2)).high, 4, 1e-12);
  EXPECT_EQ(Pow({-2, 1}, Exactly(2)).low, 0);
  EXPECT_NEAR(Pow({-2, 1}, Exactly(3)).low, -8, 1e-12);
  EXPECT_TRUE(Pow({-2, 1}, Exactly(0.5)).may_be_nan);
}

// ---- Whatever is computed from numbers inside lies inside ---------------------------------------

bool Has(const Interval& x, double value) {
  if (std::isnan(value)) return x.may_be_nan;
  if (std::isinf(value) && !x.may_be_infinite) return false;
  return Contains(x, value);
}

class RandomIntervals {
 public:
  Interval Next() {
    const double a = Number();
    const double b = Number();
    Interval x{std::min(a, b), std::max(a, b)};
    if (Chance(0.1)) x.low = -kInfinity;
    if (Chance(0.1)) x.high = kInfinity;
    if (Chance(0.1)) x.may_be_infinite = !IsBounded(x);
    if (Chance(0.1)) x.may_be_nan = true;
    return x;
  }

  double Inside(const Interval& x) {
    if (x.may_be_nan && Chance(0.2)) return std::numeric_limits<double>::quiet_NaN();
    if (x.may_be_infinite && x.high == kInfinity && Chance(0.3)) return kInfinity;
    if (x.may_be_infinite && x.low == -kInfinity && Chance(0.3)) return -kInfinity;
    const double low = std::max(x.low, -1e9);
    const double high = std::min(x.high, 1e9);
    if (Chance(0.2)) return low;
    if (Chance(0.2)) return high;
    if (Contains(x, 0) && Chance(0.2)) return Chance(0.5) ? 0.0 : -0.0;
    return std::clamp(low + Uniform() * (high - low), low, high);
  }

 private:
  double Number() {
    constexpr std::array kSpecial = {0.0, 1.0, -1.0, 3.141592653589793, 0.5, 1e-300, 700.0, 1e9};
    if (Chance(0.4)) return kSpecial[random_() % kSpecial.size()];
    return (Uniform() * 2 - 1) * std::pow(10, Uniform() * 8 - 4);
  }
  double Uniform() { return std::uniform_real_distribution<double>()(random_); }
  bool Chance(double probability) { return Uniform() < probability; }

  std::mt19937 random_{1};
};

struct Binary {
  const char* name;
  std::function<Interval(const Interval&, const Interval&)> bounds;
  std::function<double(double, double)> value;
};

double Smaller(double a, double b) { return a < b || std::isnan(a) ? a : b; }
double Larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }

Binary Operation(const char* name, BinaryOperator op, std::function<double(double, double)> value) {
  return {name, [op](const Interval& a, const Interval& b) { return Calculate(op, a, b); },
          std::move(value)};
}

TEST(Interval, HoldsWhateverTwoNumbersInsideGive) {
  const std::vector<Binary> operations = {
      Operation("+", kAdd, [](double a, double b) { return a + b; }),
      Operation("-", kSubtract, [](double a, double b) { return a - b; }),
      Operation("*", kMultiply, [](double a, double b) { return a * b; }),
      Operation("/", kDivide, [](double a, double b) { return a / b; }),
      Operation("<", kLess, [](double a, double b) { return a < b; }),
      Operation("<=", kLessEqual, [](double a, double b) { return a <= b; }),
      Operation(">", kGreater, [](double a, double b) { return a > b; }),
      Operation(">=", kGreaterEqual, [](double a, double b) { return a >= b; }),
      Operation("==", kEqual, [](double a, double b) { return a == b; }),
      Operation("!=", kNotEqual, [](double a, double b) { return a != b; }),
      {"min", Min, Smaller},
      {"max", Max, Larger},
      {"atan2", Atan2, [](double a, double b) { return std::atan2(a, b); }},
      {"pow", Pow, [](double a, double b) { return std::pow(a, b); }},
  };
  RandomIntervals random;
  for (const Binary& operation : operations)
    for (int i = 0; i < 3000; ++i) {
      const Interval a = random.Next();
      const Interval b = random.Next();
      const Interval bounds = operation.bounds(a, b);
      for (int j = 0; j < 5; ++j) {
        const double x = random.Inside(a);
        const double y = random.Inside(b);
        const double value = operation.value(x, y);
        ASSERT_TRUE(Has(bounds, value))
            << operation.name << " of " << x << " and " << y << " is " << value << ", not in "
            << bounds.low << " .. " << bounds.high;
      }
    }
}

TEST(Interval, HoldsWhateverANumberInsideGives) {
  struct Unary {
    const char* name;
    Interval (*bounds)(const Interval&);
    std::function<double(double)> value;
  };
  const std::vector<Unary> functions = {
      {"-", Negate, [](double x) { return -x; }},
      {"abs", Abs, [](double x) { return std::abs(x); }},
      {"square", Square, [](double x) { return x * x; }},
      {"sqrt", Sqrt, [](double x) { return std::sqrt(x); }},
      {"exp", Exp, [](double x) { return std::exp(x); }},
      {"log", Log, [](double x) { return std::log(x); }},
      {"tanh", Tanh, [](double x) { return std::tanh(x); }},
      {"sin", Sin, [](double x) { return std::sin(x); }},
      {"cos", Cos, [](double x) { return std::cos(x); }},
      {"tan", Tan, [](double x) { return std::tan(x); }},
      {"asin", Asin, [](double x) { return std::asin(x); }},
      {"acos", Acos, [](double x) { return std::acos(x); }},
      {"atan", Atan, [](double x) { return std::atan(x); }},
      {"floor", Floor, [](double x) { return std::floor(x); }},
      {"ceil", Ceil, [](double x) { return std::ceil(x); }},
      {"round", Round, [](double x) { return std::round(x); }},
  };
  RandomIntervals random;
  for (const Unary& function : functions)
    for (int i = 0; i < 5000; ++i) {
      const Interval a = random.Next();
      const Interval bounds = function.bounds(a);
      for (int j = 0; j < 5; ++j) {
        const double x = random.Inside(a);
        ASSERT_TRUE(Has(bounds, function.value(x)))
            << function.name << " of " << x << " is " << function.value(x) << ", not in "
            << bounds.low << " .. " << bounds.high;
      }
    }
}

}  // namespace
}  // namespace compiler
