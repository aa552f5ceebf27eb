#include "compiler/evaluate/value.h"

namespace compiler {

Value Filled(Scalar scalar, size_t size, double number) {
  if (scalar == Scalar::kReal) return Reals(size, number);
  return Integers(size, static_cast<int64_t>(number));
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

}  // namespace compiler
