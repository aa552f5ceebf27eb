#include "compiler/check/apply.h"

#include <cmath>
#include <cstdlib>

#include "compiler/check/arithmetic.h"

namespace compiler {
namespace {

Reals Products(const Reals& v, const Reals& w) {
  Reals products;
  for (size_t i = 0; i < v.size(); ++i) products.push_back(v[i] * w[i]);
  return products;
}

// The products of two vectors, or of the vectors of two arrays.
Reals Dots(const Reals& v, const Reals& w, size_t vectors) {
  const Reals products = Products(v, w);
  const size_t length = products.size() / vectors;
  Reals dots;
  for (size_t i = 0; i < vectors; ++i) {
    dots.push_back(Calculate(Builtin::kSum, std::span(products).subspan(i * length, length)));
  }
  return dots;
}

Reals Norms(const Reals& v, size_t vectors) {
  Reals norms = Dots(v, v, vectors);
  for (double& norm : norms) norm = std::sqrt(norm);
  return norms;
}

Reals Cross(const Reals& v, const Reals& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

// All values in one row, as ints where all are.
Value Joined(const std::vector<Value>& values) {
  Integers integers;
  for (const Value& value : values) {
    const auto* elements = std::get_if<Integers>(&value);
    if (elements == nullptr) {
      Reals reals;
      for (const Value& part : values) {
        for (double element : ToReals(part)) reals.push_back(element);
      }
      return reals;
    }
    integers.insert(integers.end(), elements->begin(), elements->end());
  }
  return integers;
}

template <typename Number>
Value ApplyToEach(Builtin function, const std::vector<std::vector<Number>>& arguments,
                  size_t size) {
  std::vector<Number> result;
  std::vector<Number> elements(arguments.size());
  for (size_t i = 0; i < size; ++i) {
    for (size_t k = 0; k < arguments.size(); ++k) elements[k] = ElementOf(arguments[k], i);
    result.push_back(Calculate(function, std::span<const Number>(elements)));
  }
  return result;
}

// Element by element, as ints where all are.
Value ApplyToEach(Builtin function, const std::vector<Value>& arguments, size_t size) {
  std::vector<Integers> integers;
  std::vector<Reals> reals;
  for (const Value& argument : arguments) {
    if (const auto* elements = std::get_if<Integers>(&argument)) integers.push_back(*elements);
    reals.push_back(ToReals(argument));
  }
  if (integers.size() == arguments.size()) return ApplyToEach(function, integers, size);
  return ApplyToEach(function, reals, size);
}

Value Select(const std::vector<Value>& arguments, size_t size) {
  const auto& conditions = std::get<Integers>(arguments[0]);
  return std::visit(
      [&]<typename Number>(const std::vector<Number>& wanted) -> Value {
        const auto& others = std::get<std::vector<Number>>(arguments[2]);
        std::vector<Number> selected;
        for (size_t i = 0; i < size; ++i) {
          selected.push_back(ElementOf(ElementOf(conditions, i) != 0 ? wanted : others, i));
        }
        return selected;
      },
      arguments[1]);
}

Value ApplyToAll(Builtin function, const std::vector<Value>& arguments) {
  return std::visit(
      [&]<typename Number>(const std::vector<Number>& values) -> Value {
        return std::vector<Number>{Calculate(function, std::span<const Number>(values))};
      },
      Joined(arguments));
}

bool IsArithmetic(BinaryOperator op) { return op <= BinaryOperator::kDivide; }

template <typename Number>
Value Combine(BinaryOperator op, const std::vector<Number>& left, const std::vector<Number>& right,
              size_t size) {
  std::vector<Number> result;
  for (size_t i = 0; i < size; ++i)
    result.push_back(Calculate(op, ElementOf(left, i), ElementOf(right, i)));
  return result;
}

}  // namespace

Value Apply(UnaryOperator op, Value operand) {
  std::visit(
      [&](auto& elements) {
        for (auto& element : elements) element = Calculate(op, element);
      },
      operand);
  return operand;
}

Value Apply(BinaryOperator op, const Value& left, const Value& right, size_t size) {
  if (const auto* reals = std::get_if<Reals>(&left)) {
    const auto& others = std::get<Reals>(right);
    if (IsArithmetic(op)) return Combine(op, *reals, others, size);
    Integers holds;
    for (size_t i = 0; i < size; ++i)
      holds.push_back(Holds(op, ElementOf(*reals, i), ElementOf(others, i)));
    return holds;
  }
  return Combine(op, std::get<Integers>(left), std::get<Integers>(right), size);
}

Value Apply(Builtin function, const std::vector<Value>& arguments, const Type& type) {
  switch (function) {
    case Builtin::kNorm:
      return Norms(ToReals(arguments[0]), type.size());
    case Builtin::kDot:
      return Dots(ToReals(arguments[0]), ToReals(arguments[1]), type.size());
    case Builtin::kCross:
      return Cross(ToReals(arguments[0]), ToReals(arguments[1]));
    case Builtin::kSelect:
      return Select(arguments, type.size());
    case Builtin::kVector:
      return Joined(arguments);
    case Builtin::kAny:
    case Builtin::kAll:
    case Builtin::kNone:
    case Builtin::kCount:
    case Builtin::kSum:
      return ApplyToAll(function, arguments);
    case Builtin::kMin:
    case Builtin::kMax:
      if (arguments.size() == 1) return ApplyToAll(function, arguments);
      return ApplyToEach(function, arguments, type.size());
    case Builtin::kAbs:
    case Builtin::kSign:
    case Builtin::kClamp:
    case Builtin::kSqrt:
    case Builtin::kExp:
    case Builtin::kLog:
    case Builtin::kTanh:
    case Builtin::kSin:
    case Builtin::kCos:
    case Builtin::kAtan2:
    case Builtin::kTan:
    case Builtin::kAsin:
    case Builtin::kAcos:
    case Builtin::kAtan:
    case Builtin::kPow:
    case Builtin::kFloor:
    case Builtin::kCeil:
    case Builtin::kRound:
      return ApplyToEach(function, arguments, type.size());
  }
  std::abort();
}

}  // namespace compiler
