// The values of a task: as constants have them, and as the evaluator holds them.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

// The elements of a value, row by row; a scalar has one. A bool is 0 or 1.
using Integers = std::vector<int64_t>;
using Reals = std::vector<double>;
using Value = std::variant<Integers, Reals>;

// `size` elements, all `number`.
Value Filled(Scalar scalar, size_t size, double number);

// These elements; ints and bools as exact numbers.
Value MakeValue(Scalar scalar, const std::vector<double>& elements);

size_t SizeOf(const Value& value);
// The first element; of a bool, whether it is true.
double RealOf(const Value& value);
bool IsTrue(const Value& value);
// Each element as a double: exact but for ints beyond 2^53.
Reals ToReals(const Value& value);

// One element; a scalar has the same everywhere.
template <typename Number>
Number ElementOf(const std::vector<Number>& elements, size_t i) {
  return elements.size() == 1 ? elements.front() : elements[i];
}

// The elements at `indices`, in that order.
Value Pick(const Value& value, const std::vector<uint32_t>& indices);

// Sets the elements of `place` at `indices`, all where there are none: to `value`'s element by
// element, or each to the one that a scalar has.
void Assign(AssignOperator op, const std::vector<uint32_t>& indices, const Value& value,
            Value& place);

}  // namespace compiler
