// Elements of vectors, matrices, quaternions and arrays: `.xy`, `[head]`, `[0, 2]`.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `operand.member`: one to four of x, y, z, w of a vector, of w, x, y, z of a quaternion. Both
// functions report a mistake and then return nothing.
std::optional<CheckedExpression> CheckMember(CheckedExpression operand, const Identifier& member,
                                             Diagnostics& diagnostics);

// `operand[items]`: a set of elements; of a matrix `[row, column]`, one of which may be a set.
std::optional<CheckedExpression> CheckIndex(CheckedExpression operand,
                                            const std::vector<ExpressionPtr>& items, Span span,
                                            const TaskScope& scope);

}  // namespace compiler
