// The operators: which values they take, and the type and unit of what they give.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/conversion.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `-x`, `not x`. Element-wise where the operand has a shape. All of these functions return nothing
// after they have reported a mistake; what they return is folded.
std::optional<CheckedExpression> CheckUnaryOperator(UnaryOperator op, Span span,
                                                    CheckedExpression operand,
                                                    Diagnostics& diagnostics);

// `x + y`, `x < y`, `x and y`. Arithmetic is element-wise where an operand has a shape; a scalar
// then applies to each element, a vector to each vector of an array, and an array of factors or
// divisors to the vectors of an array as long. Comparisons and logic take scalars. `/` always
// gives a real.
std::optional<CheckedExpression> CheckBinaryOperator(BinaryOperator op, Span op_span, Operand left,
                                                     Operand right, Diagnostics& diagnostics);

// `left op right within tolerance`, where `op` is `==` or `!=`.
std::optional<CheckedExpression> CheckWithin(BinaryOperator op, Span op_span, Operand left,
                                             Operand right, Operand tolerance,
                                             Diagnostics& diagnostics);

}  // namespace compiler
