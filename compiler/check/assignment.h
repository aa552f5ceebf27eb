// Assignments to memory: `n = e`, `n += e`, `place.xy = e`, `touched[feet] = false`.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Reports mistakes and then returns nothing. Where a scalar is combined with several elements, as
// in `v *= 2`, the result is the assignment `v = v * 2`.
std::optional<CheckedAssign> CheckAssignment(const AssignStatement& assign, const Place& place,
                                             const TaskScope& scope, const CheckedTask& task);

// The operator of `+=`, `-=`, `*=` or `/=`.
BinaryOperator OperatorOf(AssignOperator op);

}  // namespace compiler
