#include "compiler/interpret/builtins.h"

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

Value ApplyToEach(Builtin function, const Value& value) {
  return std::visit(
      [&]<typename Number>(std::vector<Number> elements) -> Value {
        for (Number& element : elements) {
          element = Calculate(function, std::span<const Number>(&element, 1));
        }
        return elements;
      },
      value);
}

Value ApplyToAll(Builtin function, const std::vector<Value>& arguments) {
  return std::visit(
      [&]<typename Number>(const std::vector<Number>& values) -> Value {
        return std::vector<Number>{Calculate(function, std::span<const Number>(values))};
      },
      Joined(arguments));
}

}  // namespace

Value Apply(Builtin function, const std::vector<Value>& arguments, const Type& type) {
  switch (function) {
    case Builtin::kNorm:
      return Norms(ToReals(arguments[0]), type.size());
    case Builtin::kDot:
      return Dots(ToReals(arguments[0]), ToReals(arguments[1]), type.size());
    case Builtin::kCross:
      return Cross(ToReals(arguments[0]), ToReals(arguments[1]));
    case Builtin::kSelect:
      return ToReals(arguments[0])[0] != 0 ? arguments[1] : arguments[2];
    case Builtin::kVector:
      return Joined(arguments);
    case Builtin::kAbs:
    case Builtin::kSign:
      return ApplyToEach(function, arguments[0]);
    case Builtin::kAny:
    case Builtin::kAll:
    case Builtin::kNone:
    case Builtin::kCount:
    case Builtin::kSum:
    case Builtin::kMin:
    case Builtin::kMax:
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
      return ApplyToAll(function, arguments);
  }
  std::abort();
}

}  // namespace compiler
