// Copies of checked expressions, which are never made by accident.
#pragma once

#include <cstddef>

#include "compiler/check/checked_task.h"

namespace compiler {

CheckedExpression CopyOf(const CheckedExpression& expression);

// The number of nodes.
// Do the two compute the same, in the same way?
bool IsSame(const CheckedExpression& a, const CheckedExpression& b);

size_t SizeOf(const CheckedExpression& expression);

}  // namespace compiler
