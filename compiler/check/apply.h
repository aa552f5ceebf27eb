// The operators and functions of the language, applied to values.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

// Element by element; of two operands a scalar applies to each element of the other. `size`: of the
// result.
Value Apply(UnaryOperator op, Value operand);
Value Apply(BinaryOperator op, const Value& left, const Value& right, size_t size);

// `function` with checked arguments; `type` is that of the result.
Value Apply(Builtin function, const std::vector<Value>& arguments, const Type& type);

}  // namespace compiler
