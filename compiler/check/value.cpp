#include "compiler/check/value.h"

#include "compiler/check/arithmetic.h"

namespace compiler {
namespace {

template <typename Number>
Number Assigned(AssignOperator op, Number old, Number value) {
  switch (op) {
    case AssignOperator::kSet:
      return value;
    case AssignOperator::kAdd:
      return Calculate(BinaryOperator::kAdd, old, value);
    case AssignOperator::kSubtract:
      return Calculate(BinaryOperator::kSubtract, old, value);
    case AssignOperator::kMultiply:
      return Calculate(BinaryOperator::kMultiply, old, value);
    case AssignOperator::kDivide:
      break;
  }
  return Calculate(BinaryOperator::kDivide, old, value);
}

}  // namespace

Value Filled(Scalar scalar, size_t size, double number) {
  if (scalar == Scalar::kReal) return Reals(size, number);
  return Integers(size, static_cast<int64_t>(number));
}

Value MakeValue(Scalar scalar, const std::vector<double>& elements) {
  if (scalar == Scalar::kReal) return elements;
  return Integers(elements.begin(), elements.end());
}

size_t SizeOf(const Value& value) {
  return std::visit([](const auto& elements) { return elements.size(); }, value);
}

double RealOf(const Value& value) {
  return std::visit([](const auto& elements) { return static_cast<double>(elements.front()); },
                    value);
}

bool IsTrue(const Value& value) { return std::get<Integers>(value).front() != 0; }

Reals ToReals(const Value& value) {
  return std::visit([](const auto& elements) { return Reals(elements.begin(), elements.end()); },
                    value);
}

Value Pick(const Value& value, const std::vector<uint32_t>& indices) {
  return std::visit(
      [&]<typename ElementsType>(const ElementsType& elements) -> Value {
        ElementsType picked;
        for (uint32_t index : indices) picked.push_back(elements[index]);
        return picked;
      },
      value);
}

void Assign(AssignOperator op, const std::vector<uint32_t>& indices, const Value& value,
            Value& place) {
  const size_t count = indices.empty() ? SizeOf(place) : indices.size();
  std::visit(
      [&]<typename ElementsType>(ElementsType& elements) {
        const auto& values = std::get<ElementsType>(value);
        for (size_t i = 0; i < count; ++i) {
          auto& element = elements[indices.empty() ? i : indices[i]];
          element = Assigned(op, element, values[values.size() == 1 ? 0 : i]);
        }
      },
      place);
}

}  // namespace compiler
