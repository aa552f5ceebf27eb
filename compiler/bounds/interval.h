// Interval arithmetic over the numbers that a compiled task computes.
//
// The bounds are those of the doubles themselves, rounding included: addition, multiplication,
// division and square root round monotonously, so the ends of the operands give the ends of the
// result; functions of the library get a few last digits to spare.
//
// A number without bound (a sensor whose range nobody gives) is taken to be finite, and so far from
// the largest double that sums and products of a few of them are no infinity.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The values that a number can have: from `low` to `high`, both included. A bool is 0 or 1. Where
// low > high there is none.
struct Interval {
  double low = -kInfinity;
  double high = kInfinity;
  bool may_be_infinite = false;  // an infinity itself is among the values, as after x / 0
  bool may_be_nan = false;

  bool operator==(const Interval&) const = default;
};

inline constexpr Interval kAnything{-kInfinity, kInfinity, true, true};
inline constexpr Interval kNothing{kInfinity, -kInfinity};
inline constexpr Interval kAnyBool{0, 1};

// The result for an operand that is never a number, or that does not exist.
inline constexpr Interval NoNumber(bool may_be_nan) {
  return {kNothing.low, kNothing.high, false, may_be_nan};
}

inline Interval Exactly(double value) { return {value, value}; }
inline bool HasNumber(const Interval& x) { return x.low <= x.high; }
inline bool IsEmpty(const Interval& x) { return x.low > x.high && !x.may_be_nan; }
inline bool IsExact(const Interval& x) { return x.low == x.high && !x.may_be_nan; }
inline bool IsBounded(const Interval& x) { return x.low > -kInfinity && x.high < kInfinity; }
inline bool Contains(const Interval& x, double value) { return x.low <= value && value <= x.high; }
inline bool MayBeTrue(const Interval& condition) { return condition.high >= 1; }
inline bool MayBeFalse(const Interval& condition) { return condition.low <= 0; }
// The largest magnitude.
double Magnitude(const Interval& x);

// All values of both; those that both have.
Interval Join(const Interval& a, const Interval& b);
Interval Meet(const Interval& a, const Interval& b);

// Every value of a type.
Interval AnyOf(Scalar scalar);

// ---- Operators. `scalar` is the type of the operands: integers wrap around. ---------------------

Interval Negate(const Interval& x);
Interval Not(const Interval& condition);
Interval Calculate(BinaryOperator op, const Interval& left, const Interval& right, Scalar scalar);

// `x` and a few of the next doubles on both sides.
Interval Widened(const Interval& x);

// ---- Functions of single numbers ----------------------------------------------------------------

Interval Abs(const Interval& x);
Interval Min(const Interval& a, const Interval& b);
Interval Max(const Interval& a, const Interval& b);
Interval Sqrt(const Interval& x);
Interval Exp(const Interval& x);
Interval Log(const Interval& x);
Interval Tanh(const Interval& x);
Interval Sin(const Interval& angle);
Interval Cos(const Interval& angle);
Interval Atan2(const Interval& y, const Interval& x);
// x * x: never negative, which the product of two equal intervals does not know.
Interval Square(const Interval& x);

// ---- Values with a shape ------------------------------------------------------------------------

// The intervals of a value's elements. A single one stands for all of them, whether the value is
// a scalar, or that it has too many elements to tell apart.
//
// The analysis copies all boxes at each branch, and changes few of them: so copies share several
// elements until one of them is changed, and a single one needs no memory of its own.
class Box {
 public:
  Box() = default;
  explicit Box(Interval all) : single_(all), size_(1) {}
  explicit Box(std::vector<Interval> elements) : size_(elements.size()) {
    if (size_ == 1) single_ = elements[0];
    if (size_ > 1) several_ = std::make_shared<std::vector<Interval>>(std::move(elements));
  }

  const Interval& operator[](size_t i) const { return size_ > 1 ? (*several_)[i] : single_; }
  void Set(size_t i, Interval element) {
    if (size_ <= 1) {
      single_ = element;
      return;
    }
    if (several_.use_count() > 1) several_ = std::make_shared<std::vector<Interval>>(*several_);
    (*several_)[i] = element;
  }
  size_t size() const { return size_; }
  // Valid while this box lives and stays as it is.
  std::span<const Interval> elements() const {
    return size_ > 1 ? std::span<const Interval>(*several_) : std::span(&single_, size_);
  }

  // Whether the two are copies of each other; false may mean that they are equal nevertheless.
  bool IsCopyOf(const Box& other) const { return size_ > 1 && several_ == other.several_; }
  bool operator==(const Box& other) const {
    return IsCopyOf(other) || std::ranges::equal(elements(), other.elements());
  }

 private:
  Interval single_;
  size_t size_ = 0;
  std::shared_ptr<std::vector<Interval>> several_;  // null where there is no more than one
};

}  // namespace compiler
