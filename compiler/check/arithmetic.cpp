#include "compiler/check/arithmetic.h"

#include <cmath>
#include <cstdlib>

namespace compiler {
namespace {

// Signed overflow is undefined in C++, unsigned overflow is not.
int64_t Add(int64_t left, int64_t right) {
  return static_cast<int64_t>(static_cast<uint64_t>(left) + static_cast<uint64_t>(right));
}
int64_t Subtract(int64_t left, int64_t right) {
  return static_cast<int64_t>(static_cast<uint64_t>(left) - static_cast<uint64_t>(right));
}
int64_t Multiply(int64_t left, int64_t right) {
  return static_cast<int64_t>(static_cast<uint64_t>(left) * static_cast<uint64_t>(right));
}

template <typename Number>
bool IsTrue(BinaryOperator op, Number left, Number right) {
  switch (op) {
    case BinaryOperator::kLess:
      return left < right;
    case BinaryOperator::kLessEqual:
      return left <= right;
    case BinaryOperator::kGreater:
      return left > right;
    case BinaryOperator::kGreaterEqual:
      return left >= right;
    case BinaryOperator::kEqual:
      return left == right;
    case BinaryOperator::kNotEqual:
      return left != right;
    case BinaryOperator::kAnd:
      return left != 0 && right != 0;
    case BinaryOperator::kOr:
      return left != 0 || right != 0;
    default:
      return false;
  }
}

// Not a number where one of them is not a number.
template <typename Number>
Number Smaller(Number left, Number right) {
  return left < right || left != left ? left : right;
}
template <typename Number>
Number Larger(Number left, Number right) {
  return left > right || left != left ? left : right;
}

template <typename Number, typename Join>
Number JoinAll(std::span<const Number> values, const Join& join) {
  Number joined = values.front();
  for (Number value : values.subspan(1)) joined = join(joined, value);
  return joined;
}

double Magnitude(double value) { return std::abs(value); }
int64_t Magnitude(int64_t value) { return value < 0 ? Subtract(0, value) : value; }

// Functions of reals are never asked for with ints: the checker makes reals of them first.
template <typename Number>
Number Apply(Builtin function, std::span<const Number> values) {
  const Number x = values[0];
  const auto of = [](double result) { return static_cast<Number>(result); };
  switch (function) {
    case Builtin::kAny:
      return JoinAll(values, [](Number a, Number b) -> Number { return a != 0 || b != 0; });
    case Builtin::kNone:
      return Apply(Builtin::kAny, values) == 0;
    case Builtin::kAll:
      return JoinAll(values, [](Number a, Number b) -> Number { return a != 0 && b != 0; });
    case Builtin::kCount:
    case Builtin::kSum:
      return JoinAll(values,
                     [](Number a, Number b) { return Calculate(BinaryOperator::kAdd, a, b); });
    case Builtin::kAbs:
      return Magnitude(x);
    case Builtin::kMin:
      return JoinAll(values, Smaller<Number>);
    case Builtin::kMax:
      return JoinAll(values, Larger<Number>);
    case Builtin::kClamp:
      return Smaller(Larger(x, values[1]), values[2]);
    case Builtin::kSqrt:
      return of(std::sqrt(x));
    case Builtin::kExp:
      return of(std::exp(x));
    case Builtin::kLog:
      return of(std::log(x));
    case Builtin::kTanh:
      return of(std::tanh(x));
    case Builtin::kSin:
      return of(std::sin(x));
    case Builtin::kCos:
      return of(std::cos(x));
    case Builtin::kAtan2:
      return of(std::atan2(x, values[1]));
    case Builtin::kTan:
      return of(std::tan(x));
    case Builtin::kAsin:
      return of(std::asin(x));
    case Builtin::kAcos:
      return of(std::acos(x));
    case Builtin::kAtan:
      return of(std::atan(x));
    case Builtin::kPow:
      return of(std::pow(x, values[1]));
    case Builtin::kSign:
      return x > 0 ? Number{1} : x < 0 ? Number{-1} : x;
    case Builtin::kFloor:
      return of(std::floor(x));
    case Builtin::kCeil:
      return of(std::ceil(x));
    case Builtin::kRound:
      return of(std::round(x));
    case Builtin::kSelect:
      return x != 0 ? values[1] : values[2];
    case Builtin::kNorm:
    case Builtin::kDot:
    case Builtin::kCross:
    case Builtin::kVector:
      break;  // their arguments have a shape
  }
  std::abort();
}

}  // namespace

double Calculate(UnaryOperator op, double operand) {
  return op == UnaryOperator::kNegate ? -operand : operand == 0;
}

int64_t Calculate(UnaryOperator op, int64_t operand) {
  return op == UnaryOperator::kNegate ? Subtract(0, operand) : operand == 0;
}

bool Holds(BinaryOperator comparison, double left, double right) {
  return IsTrue(comparison, left, right);
}

double Calculate(BinaryOperator op, double left, double right) {
  switch (op) {
    case BinaryOperator::kAdd:
      return left + right;
    case BinaryOperator::kSubtract:
      return left - right;
    case BinaryOperator::kMultiply:
      return left * right;
    case BinaryOperator::kDivide:
      return left / right;
    default:
      return IsTrue(op, left, right);
  }
}

int64_t Calculate(BinaryOperator op, int64_t left, int64_t right) {
  switch (op) {
    case BinaryOperator::kAdd:
      return Add(left, right);
    case BinaryOperator::kSubtract:
      return Subtract(left, right);
    case BinaryOperator::kMultiply:
      return Multiply(left, right);
    default:
      return IsTrue(op, left, right);
  }
}

double Calculate(Builtin function, std::span<const double> values) {
  return Apply(function, values);
}

int64_t Calculate(Builtin function, std::span<const int64_t> values) {
  return Apply(function, values);
}

}  // namespace compiler
