#include "compiler/bounds/interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace compiler {
namespace {

// Integers are the doubles' whole numbers up to here; sums of smaller ones do not wrap around.
constexpr double kSafeInt = 4e18;  // a little less than 2^62
// What is added to a counter: it would have to count for ages to wrap around.
constexpr double kSmallInt = 2147483648;

// The sign tells which: +inf belongs to an interval that has no upper end.
bool MayBePlusInfinity(const Interval& x) { return x.may_be_infinite && x.high == kInfinity; }
bool MayBeMinusInfinity(const Interval& x) { return x.may_be_infinite && x.low == -kInfinity; }

// The largest magnitude that is reckoned with where there is no bound.
double OrdinaryMagnitude(const Interval& x) {
  constexpr double kOrdinary = 1e100;
  const double magnitude = Magnitude(x);
  return std::isfinite(magnitude) ? magnitude : kOrdinary;
}

Interval Sum(const Interval& a, const Interval& b) {
  Interval sum{a.low + b.low, a.high + b.high};
  // What is certainly an infinity is one beside any number, also one without bound.
  if (std::isnan(sum.low)) sum.low = kInfinity;
  if (std::isnan(sum.high)) sum.high = -kInfinity;
  sum.may_be_infinite = a.may_be_infinite || b.may_be_infinite ||
                        std::isinf(OrdinaryMagnitude(a) + OrdinaryMagnitude(b));
  if (IsBounded(sum)) sum.may_be_infinite = false;
  sum.may_be_nan = a.may_be_nan || b.may_be_nan ||
                   (MayBePlusInfinity(a) && MayBeMinusInfinity(b)) ||
                   (MayBeMinusInfinity(a) && MayBePlusInfinity(b));
  return sum;
}

// Of two ends: beside a 0, an end that is missing does not count.
double EndProduct(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Interval Product(const Interval& a, const Interval& b) {
  const auto [low, high] = std::minmax({EndProduct(a.low, b.low), EndProduct(a.low, b.high),
                                        EndProduct(a.high, b.low), EndProduct(a.high, b.high)});
  Interval product{low, high};
  product.may_be_infinite = a.may_be_infinite || b.may_be_infinite ||
                            std::isinf(OrdinaryMagnitude(a) * OrdinaryMagnitude(b));
  product.may_be_nan = a.may_be_nan || b.may_be_nan || (a.may_be_infinite && Contains(b, 0)) ||
                       (b.may_be_infinite && Contains(a, 0));
  if (IsBounded(product)) product.may_be_infinite = false;
  return product;
}

Interval Quotient(const Interval& a, const Interval& b) {
  if (Contains(b, 0)) {
    Interval quotient = kAnything;
    quotient.may_be_nan =
        a.may_be_nan || b.may_be_nan || Contains(a, 0) || (a.may_be_infinite && b.may_be_infinite);
    return quotient;
  }
  if (b.high < 0) return Quotient(Negate(a), Negate(b));
  // Here the divisor is above 0; an infinite one divides to 0.
  Interval quotient{a.low < 0 ? a.low / b.low : a.low / b.high,
                    a.high < 0 ? a.high / b.high : a.high / b.low};
  if (std::isnan(quotient.low)) quotient.low = 0;
  if (std::isnan(quotient.high)) quotient.high = 0;
  quotient.may_be_infinite = a.may_be_infinite || std::isinf(OrdinaryMagnitude(a) / b.low);
  if (IsBounded(quotient)) quotient.may_be_infinite = false;
  quotient.may_be_nan = a.may_be_nan || b.may_be_nan || (a.may_be_infinite && b.may_be_infinite);
  return quotient;
}

// What does not stay far from the largest integer may be any: it wraps around.
Interval IntResult(const Interval& result, const Interval& a, const Interval& b,
                   double small_enough) {
  const bool is_small = IsBounded(a) && IsBounded(b) && Magnitude(result) <= kSafeInt;
  const bool counts =
      std::min(Magnitude(a), Magnitude(b)) <= small_enough && (!IsBounded(a) || !IsBounded(b));
  if (!is_small && !counts) return AnyOf(Scalar::kInt);
  return {result.low, result.high};
}

Interval Truth(bool may_be_true, bool may_be_false) {
  return {may_be_false ? 0.0 : 1.0, may_be_true ? 1.0 : 0.0};
}

Interval Less(const Interval& a, const Interval& b) {
  const bool is_number = HasNumber(a) && HasNumber(b);
  return Truth(is_number && a.low < b.high,
               !is_number || a.may_be_nan || b.may_be_nan || a.high >= b.low);
}

Interval LessEqual(const Interval& a, const Interval& b) {
  const bool is_number = HasNumber(a) && HasNumber(b);
  return Truth(is_number && a.low <= b.high,
               !is_number || a.may_be_nan || b.may_be_nan || a.high > b.low);
}

Interval Equal(const Interval& a, const Interval& b) {
  const bool overlap = std::max(a.low, b.low) <= std::min(a.high, b.high);
  return Truth(overlap, !(IsExact(a) && IsExact(b) && a.low == b.low));
}

// A function that never falls, as the library computes it.
template <typename Function>
Interval Rising(const Function& function, const Interval& x, double least, double largest) {
  if (!HasNumber(x)) return NoNumber(x.may_be_nan);
  Interval result = Widened({function(x.low), function(x.high)});
  result.low = std::max(result.low, least);
  result.high = std::min(result.high, largest);
  result.may_be_nan = x.may_be_nan;
  return result;
}

// sin(x + shift), where `shift` is 0 or a quarter turn, and `function` computes it.
template <typename Function>
Interval Wave(const Function& function, const Interval& x, double shift) {
  if (!HasNumber(x)) return NoNumber(x.may_be_nan);
  Interval result{-1, 1};
  result.may_be_nan = x.may_be_nan || x.may_be_infinite;
  // Beyond some turns the places of the crests are not exact enough.
  constexpr double kManyTurns = 1e5;
  constexpr double kMargin = 1e-9;
  if (Magnitude(x) > kManyTurns) return result;
  const auto reaches = [&](double crest) {
    const double first = crest - shift;
    const double turn = 2 * std::numbers::pi;
    const double next = first + turn * std::ceil((x.low - kMargin - first) / turn);
    return next <= x.high + kMargin;
  };
  const Interval ends = Widened(Join(Exactly(function(x.low)), Exactly(function(x.high))));
  if (!reaches(-std::numbers::pi / 2)) result.low = std::max(-1.0, ends.low);
  if (!reaches(std::numbers::pi / 2)) result.high = std::min(1.0, ends.high);
  return result;
}

}  // namespace

double Magnitude(const Interval& x) {
  return HasNumber(x) ? std::max(std::abs(x.low), std::abs(x.high)) : 0;
}

Interval Join(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), a.may_be_infinite || b.may_be_infinite,
          a.may_be_nan || b.may_be_nan};
}

Interval Meet(const Interval& a, const Interval& b) {
  Interval both{std::max(a.low, b.low), std::min(a.high, b.high),
                a.may_be_infinite && b.may_be_infinite, a.may_be_nan && b.may_be_nan};
  if (!HasNumber(both)) return NoNumber(both.may_be_nan);
  both.may_be_infinite = both.may_be_infinite && !IsBounded(both);
  return both;
}

Interval AnyOf(Scalar scalar) { return scalar == Scalar::kBool ? kAnyBool : Interval{}; }

Interval Negate(const Interval& x) { return {-x.high, -x.low, x.may_be_infinite, x.may_be_nan}; }

Interval Not(const Interval& condition) {
  return Truth(MayBeFalse(condition), MayBeTrue(condition));
}

Interval Calculate(BinaryOperator op, const Interval& left, const Interval& right, Scalar scalar) {
  switch (op) {
    case BinaryOperator::kLess:
      return Less(left, right);
    case BinaryOperator::kLessEqual:
      return LessEqual(left, right);
    case BinaryOperator::kGreater:
      return Less(right, left);
    case BinaryOperator::kGreaterEqual:
      return LessEqual(right, left);
    case BinaryOperator::kEqual:
      return Equal(left, right);
    case BinaryOperator::kNotEqual:
      return Not(Equal(left, right));
    case BinaryOperator::kAnd:
      return Truth(MayBeTrue(left) && MayBeTrue(right), MayBeFalse(left) || MayBeFalse(right));
    case BinaryOperator::kOr:
      return Truth(MayBeTrue(left) || MayBeTrue(right), MayBeFalse(left) && MayBeFalse(right));
    default:
      break;
  }
  if (!HasNumber(left) || !HasNumber(right)) return NoNumber(left.may_be_nan || right.may_be_nan);
  const bool is_int = scalar == Scalar::kInt;
  switch (op) {
    case BinaryOperator::kAdd:
      return is_int ? IntResult(Sum(left, right), left, right, kSmallInt) : Sum(left, right);
    case BinaryOperator::kSubtract:
      return Calculate(BinaryOperator::kAdd, left, Negate(right), scalar);
    case BinaryOperator::kMultiply:
      return is_int ? IntResult(Product(left, right), left, right, 1) : Product(left, right);
    default:
      return Quotient(left, right);
  }
}

Interval Widened(const Interval& x) {
  if (!HasNumber(x)) return x;
  constexpr int kDigits = 4;  // the library errs by less than one
  Interval wide = x;
  for (int i = 0; i < kDigits; ++i) {
    wide.low = std::nextafter(wide.low, -kInfinity);
    wide.high = std::nextafter(wide.high, kInfinity);
  }
  return wide;
}

Interval Abs(const Interval& x) {
  if (!HasNumber(x)) return x;
  Interval result = x;
  result.low = Contains(x, 0) ? 0 : std::min(std::abs(x.low), std::abs(x.high));
  result.high = Magnitude(x);
  return result;
}

Interval Min(const Interval& a, const Interval& b) {
  if (!HasNumber(a) || !HasNumber(b)) return NoNumber(a.may_be_nan || b.may_be_nan);
  return {std::min(a.low, b.low), std::min(a.high, b.high),
          MayBeMinusInfinity(a) || MayBeMinusInfinity(b) ||
              (MayBePlusInfinity(a) && MayBePlusInfinity(b)),
          a.may_be_nan || b.may_be_nan};
}

Interval Max(const Interval& a, const Interval& b) { return Negate(Min(Negate(a), Negate(b))); }

Interval Sqrt(const Interval& x) {
  if (x.high < 0 || !HasNumber(x)) return NoNumber(x.may_be_nan || x.high < 0);
  return {std::sqrt(std::max(x.low, 0.0)), std::sqrt(x.high), MayBePlusInfinity(x),
          x.may_be_nan || x.low < 0};
}

Interval Exp(const Interval& x) {
  Interval result = Rising([](double value) { return std::exp(value); }, x, 0, kInfinity);
  // It grows so fast that a number without bound does overflow.
  result.may_be_infinite = result.high == kInfinity;
  return result;
}

Interval Log(const Interval& x) {
  if (x.high < 0 || !HasNumber(x)) return NoNumber(x.may_be_nan || x.high < 0);
  const Interval positive{std::max(x.low, 0.0), x.high, false, x.may_be_nan || x.low < 0};
  Interval result =
      Rising([](double value) { return std::log(value); }, positive, -kInfinity, kInfinity);
  result.may_be_infinite = x.low <= 0 || MayBePlusInfinity(x);
  return result;
}

Interval Tanh(const Interval& x) {
  return Rising([](double value) { return std::tanh(value); }, x, -1, 1);
}

Interval Sin(const Interval& angle) {
  return Wave([](double value) { return std::sin(value); }, angle, 0);
}

Interval Cos(const Interval& angle) {
  return Wave([](double value) { return std::cos(value); }, angle, std::numbers::pi / 2);
}

Interval Atan2(const Interval& y, const Interval& x) {
  if (!HasNumber(y) || !HasNumber(x)) return NoNumber(y.may_be_nan || x.may_be_nan);
  Interval result = Widened({-std::numbers::pi, std::numbers::pi});
  // Where the origin and the cut behind it are not inside, the corners are the extremes.
  if (x.low > 0 || y.low > 0 || y.high < 0) {
    const auto [low, high] = std::minmax({std::atan2(y.low, x.low), std::atan2(y.low, x.high),
                                          std::atan2(y.high, x.low), std::atan2(y.high, x.high)});
    result = Meet(result, Widened({low, high}));
  }
  result.may_be_nan = y.may_be_nan || x.may_be_nan;
  return result;
}

Interval Square(const Interval& x) {
  const Interval magnitude = Abs(x);
  Interval result = Calculate(BinaryOperator::kMultiply, magnitude, magnitude, Scalar::kReal);
  result.may_be_nan = x.may_be_nan;
  return result;
}

}  // namespace compiler
