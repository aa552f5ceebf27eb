#include "compiler/bounds/builtin_bounds.h"

#include <algorithm>
#include <cstdlib>
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
        return Box(Extremum(Min));
      case Builtin::kMax:
        return Box(Extremum(Max));
      case Builtin::kClamp:
        return Box(Min(Max(scalar(0), scalar(1)), scalar(2)));
      case Builtin::kSqrt:
        return Box(Sqrt(scalar(0)));
      case Builtin::kExp:
        return Box(Exp(scalar(0)));
      case Builtin::kLog:
        return Box(Log(scalar(0)));
      case Builtin::kTanh:
        return Box(Tanh(scalar(0)));
      case Builtin::kSin:
        return Box(Sin(scalar(0)));
      case Builtin::kCos:
        return Box(Cos(scalar(0)));
      case Builtin::kAtan2:
        return Box(Atan2(scalar(0), scalar(1)));
      case Builtin::kTan:
        return Box(Tan(scalar(0)));
      case Builtin::kAsin:
        return Box(Asin(scalar(0)));
      case Builtin::kAcos:
        return Box(Acos(scalar(0)));
      case Builtin::kAtan:
        return Box(Atan(scalar(0)));
      case Builtin::kPow:
        return Box(Pow(scalar(0), scalar(1)));
      case Builtin::kSign:
        return EachElement(Sign);
      case Builtin::kFloor:
        return EachElement(Floor);
      case Builtin::kCeil:
        return EachElement(Ceil);
      case Builtin::kRound:
        return EachElement(Round);
      case Builtin::kSelect:
        return Select();
      case Builtin::kVector:
        return Vector();
    }
    std::abort();
  }

 private:
  const Interval& scalar(size_t argument) const { return arguments_[argument][0]; }
  const Interval& element(size_t argument, size_t i) const { return arguments_[argument][i]; }
  // The number of elements of the first argument, tracked or not.
  uint32_t size() const { return call_.arguments[0]->type.size(); }
  // The number of them that give one element of the result.
  uint32_t length() const { return size() / type_.size(); }

  template <typename Function>
  Box EachElement(const Function& function) const {
    std::vector<Interval> elements;
    for (const Interval& x : arguments_[0].elements()) elements.push_back(function(x));
    return Box(std::move(elements));
  }

  Box Select() const {
    if (!MayBeFalse(scalar(0))) return arguments_[1];
    if (!MayBeTrue(scalar(0))) return arguments_[2];
    return Join(arguments_[1], arguments_[2]);
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

  // Of two numbers, or of the elements of one value.
  template <typename Function>
  Interval Extremum(const Function& function) const {
    if (arguments_.size() == 2) return function(scalar(0), scalar(1));
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
