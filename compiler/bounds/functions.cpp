#include "compiler/bounds/functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace compiler {
namespace {

// A function that never falls and is computed without error.
template <typename Function>
Interval RisingExactly(const Function& function, const Interval& x) {
  if (!HasNumber(x)) return x;
  return {function(x.low), function(x.high), x.may_be_infinite, x.may_be_nan};
}

// A function that never falls, as the library computes it, for `x` within its domain.
template <typename Function>
Interval Rising(const Function& function, const Interval& x, const Interval& domain) {
  const Interval inside = Meet({x.low, x.high}, domain);
  const bool may_leave = x.low < domain.low || x.high > domain.high;
  if (!HasNumber(inside)) return NoNumber(x.may_be_nan || may_leave);
  Interval result = Widened({function(inside.low), function(inside.high)});
  result.may_be_nan = x.may_be_nan || may_leave;
  return result;
}

// `x` to a whole power, as far as signs and ends go: |x| to that power, and the sign of x if it is
// odd.
Interval WholePower(const Interval& x, double power) {
  const Interval size = Pow(Abs(x), Exactly(power));
  if (std::fmod(power, 2) == 0) return size;
  const Interval below = x.low < 0 ? Negate(size) : size;
  return Join(x.high > 0 ? size : below, below);
}

}  // namespace

Interval Sign(const Interval& x) {
  Interval sign =
      RisingExactly([](double value) { return double(value > 0) - double(value < 0); }, x);
  sign.may_be_infinite = false;
  return sign;
}

Interval Floor(const Interval& x) {
  return RisingExactly([](double value) { return std::floor(value); }, x);
}

Interval Ceil(const Interval& x) {
  return RisingExactly([](double value) { return std::ceil(value); }, x);
}

Interval Round(const Interval& x) {
  return RisingExactly([](double value) { return std::round(value); }, x);
}

Interval Pow(const Interval& x, const Interval& y) {
  if (!HasNumber(x) || !HasNumber(y)) return kAnything;
  const bool may_be_nan = x.may_be_nan || y.may_be_nan;
  Interval power = kAnything;
  // 0 to a negative power is an infinity of either sign.
  if (x.low > 0 || (x.low == 0 && y.low >= 0)) {
    // Along each side of the box it only rises or only falls: the corners are the extremes.
    const auto [low, high] = std::minmax({std::pow(x.low, y.low), std::pow(x.low, y.high),
                                          std::pow(x.high, y.low), std::pow(x.high, y.high)});
    power = Widened({low, high});
    power.low = std::max(power.low, 0.0);
    power.may_be_infinite = !IsBounded(power);
    power.may_be_nan = may_be_nan;
  } else if (IsExact(y) && std::trunc(y.low) == y.low && y.low >= 0) {
    power = WholePower(x, y.low);
    power.may_be_nan = may_be_nan;
  } else if (y.low >= 0) {
    const Interval size = Pow(Abs(x), y);
    power = Join(size, Negate(size));
    power.may_be_nan = true;
  }
  return power;
}

Interval Tan(const Interval& angle) {
  if (!HasNumber(angle)) return angle;
  constexpr double kMargin = 1e-9;
  const double branch =
      std::round((angle.low + angle.high) / 2 / std::numbers::pi) * std::numbers::pi;
  const bool is_within_a_branch = Magnitude(angle) < 1e5 &&
                                  angle.low > branch - std::numbers::pi / 2 + kMargin &&
                                  angle.high < branch + std::numbers::pi / 2 - kMargin;
  Interval tangent;
  if (is_within_a_branch) tangent = Widened({std::tan(angle.low), std::tan(angle.high)});
  tangent.may_be_nan = angle.may_be_nan || angle.may_be_infinite;
  return tangent;
}

Interval Asin(const Interval& x) {
  return Rising([](double value) { return std::asin(value); }, x, {-1, 1});
}

Interval Acos(const Interval& x) {
  return Negate(Rising([](double value) { return -std::acos(value); }, x, {-1, 1}));
}

Interval Atan(const Interval& x) {
  return Rising([](double value) { return std::atan(value); }, x, {});
}

}  // namespace compiler
