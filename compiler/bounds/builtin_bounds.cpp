#include "compiler/bounds/builtin_bounds.h"

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include "compiler/bounds/expression_bounds.h"
#include "compiler/bounds/functions.h"
#include "compiler/bounds/values.h"

namespace compiler {
namespace {

// One call, as its function's rules ask.
class BuiltinCalculation {
 public:
  BuiltinCalculation(const BuiltinCall& call, const std::vector<Box>& arguments, const Type& type)
      : call_(call), arguments_(arguments), type_(type) {}

  Box Calculate() const {
    switch (call_.function) {
      case Builtin::kAny:
        return Box(Any());
      case Builtin::kAll:
        return Box(All());
      case Builtin::kNone:
        return Box(Not(Any()));
      case Builtin::kCount:
      case Builtin::kSum:
        return Box(Sum());
      case Builtin::kNorm:
        return OfEachVector([&](uint32_t first) { return Sqrt(Dot(0, 0, first)); });
      case Builtin::kDot:
        return OfEachVector([&](uint32_t first) { return Dot(0, 1, first); });
      case Builtin::kCross:
        return Cross();
      case Builtin::kAbs:
        return EachElement(Abs);
      case Builtin::kMin:
        return arguments_.size() == 1 ? Box(Extremum(Min)) : EachElement(Min);
      case Builtin::kMax:
        return arguments_.size() == 1 ? Box(Extremum(Max)) : EachElement(Max);
      case Builtin::kClamp:
        return EachElement([](const Interval& x, const Interval& low, const Interval& high) {
          return Min(Max(x, low), high);
        });
      case Builtin::kSqrt:
        return EachElement(Sqrt);
      case Builtin::kExp:
        return EachElement(Exp);
      case Builtin::kLog:
        return EachElement(Log);
      case Builtin::kTanh:
        return EachElement(Tanh);
      case Builtin::kSin:
        return EachElement(Sin);
      case Builtin::kCos:
        return EachElement(Cos);
      case Builtin::kAtan2:
        return EachElement(Atan2);
      case Builtin::kTan:
        return EachElement(Tan);
      case Builtin::kAsin:
        return EachElement(Asin);
      case Builtin::kAcos:
        return EachElement(Acos);
      case Builtin::kAtan:
        return EachElement(Atan);
      case Builtin::kPow:
        return EachElement(Pow);
      case Builtin::kSign:
        return EachElement(Sign);
      case Builtin::kFloor:
        return EachElement(Floor);
      case Builtin::kCeil:
        return EachElement(Ceil);
      case Builtin::kRound:
        return EachElement(Round);
      case Builtin::kSelect:
        return EachElement(Select);
      case Builtin::kVector:
        return Vector();
    }
    std::abort();
  }

 private:
  const Interval& element(size_t argument, size_t i) const { return arguments_[argument][i]; }
  // The number of elements of the first argument, tracked or not.
  uint32_t size() const { return call_.arguments[0]->type.size(); }
  // The number of them that give one element of the result.
  uint32_t length() const { return size() / type_.size(); }

  // `function` gets an interval of each argument.
  template <typename Function>
  Box EachElement(const Function& function) const {
    size_t size = 1;
    for (const Box& argument : arguments_) size = std::max(size, argument.size());
    std::vector<Interval> elements;
    for (size_t i = 0; i < size; ++i) {
      if constexpr (std::is_invocable_v<Function, Interval>) {
        elements.push_back(function(element(0, i)));
      } else if constexpr (std::is_invocable_v<Function, Interval, Interval>) {
        elements.push_back(function(element(0, i), element(1, i)));
      } else {
        elements.push_back(function(element(0, i), element(1, i), element(2, i)));
      }
    }
    return Box(std::move(elements));
  }

  static Interval Select(const Interval& condition, const Interval& x, const Interval& y) {
    if (!MayBeFalse(condition)) return x;
    return MayBeTrue(condition) ? Join(x, y) : y;
  }

  Box Vector() const {
    std::vector<Interval> elements;
    for (const Box& argument : arguments_) elements.push_back(argument[0]);
    return MakeBox(std::move(elements));
  }

  // Of a vector, or of each one of an array. `of` gets the number of the vector's first element.
  template <typename Function>
  Box OfEachVector(const Function& of) const {
    std::vector<Interval> elements;
    for (uint32_t i = 0; i < type_.size(); ++i) elements.push_back(of(i * length()));
    return MakeBox(std::move(elements));
  }

  Interval Any() const {
    Interval any = Exactly(0);
    for (const Interval& x : arguments_[0].elements())
      any = {std::max(any.low, x.low), std::max(any.high, x.high)};
    return any;
  }

  Interval All() const {
    Interval all = Exactly(1);
    for (const Interval& x : arguments_[0].elements())
      all = {std::min(all.low, x.low), std::min(all.high, x.high)};
    return all;
  }

  Interval Sum() const {
    Interval sum = element(0, 0);
    for (uint32_t i = 1; i < size(); ++i)
      sum = compiler::Calculate(BinaryOperator::kAdd, sum, element(0, i), type_.scalar);
    return sum;
  }

  Interval Product(size_t a, size_t i, size_t b, size_t j) const {
    const bool is_square =
        i == j && (a == b || IsSameRead(*call_.arguments[a], *call_.arguments[b]));
    if (is_square) return Square(element(a, i));
    return compiler::Calculate(BinaryOperator::kMultiply, element(a, i), element(b, j),
                               Scalar::kReal);
  }

  Interval Dot(size_t a, size_t b, uint32_t first) const {
    Interval sum = Product(a, first, b, first);
    for (uint32_t i = first + 1; i < first + length(); ++i)
      sum = compiler::Calculate(BinaryOperator::kAdd, sum, Product(a, i, b, i), Scalar::kReal);
    return sum;
  }

  Box Cross() const {
    std::vector<Interval> elements;
    for (size_t i = 0; i < 3; ++i) {
      const size_t next = (i + 1) % 3;
      const size_t after = (i + 2) % 3;
      elements.push_back(compiler::Calculate(BinaryOperator::kSubtract, Product(0, next, 1, after),
                                             Product(0, after, 1, next), Scalar::kReal));
    }
    return Box(std::move(elements));
  }

  // Of the elements of one value.
  template <typename Function>
  Interval Extremum(const Function& function) const {
    Interval extremum = element(0, 0);
    for (const Interval& x : arguments_[0].elements()) extremum = function(extremum, x);
    return extremum;
  }

  const BuiltinCall& call_;
  const std::vector<Box>& arguments_;
  const Type& type_;
};

}  // namespace

Box BuiltinBounds(const BuiltinCall& call, const std::vector<Box>& arguments, const Type& type) {
  return BuiltinCalculation(call, arguments, type).Calculate();
}

}  // namespace compiler
