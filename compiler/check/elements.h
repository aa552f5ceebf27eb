// Elements of vectors, matrices, quaternions and arrays: `.xy`, `[head]`, `[0, 2]`.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `operand.member`: one to four of x, y, z, w of a vector, of w, x, y, z of a quaternion; of an
// array of such, those of each entry. Both functions report a mistake and then return nothing.
std::optional<CheckedExpression> CheckMember(CheckedExpression operand, const Identifier& member,
                                             Diagnostics& diagnostics);

// `operand[items]`: a set of elements, or of the entries of an array; of a matrix `[row, column]`,
// one of which may be a set.
std::optional<CheckedExpression> CheckIndex(CheckedExpression operand,
                                            const std::vector<ExpressionPtr>& items, Span span,
                                            const TaskScope& scope);

// The elements at `indices`, as a value of that type. Elements of elements are elements of the
// first operand, those of constants are constants.
CheckedExpression PickElements(CheckedExpression operand, std::vector<uint32_t> indices,
                               const Type& type, Span span);

// An array like `array` that has the vector in each of its entries.
CheckedExpression InEachEntry(CheckedExpression vector, const Type& array);
// An array like `array`, each entry of which consists of one of the `numbers`, an array of as many.
CheckedExpression InAllOfEachEntry(CheckedExpression numbers, const Type& array);
// Where one operand is an array of vectors: the other one as an array like it, unless it is a
// scalar.
void MakeAlike(CheckedExpression& left, CheckedExpression& right);

}  // namespace compiler
