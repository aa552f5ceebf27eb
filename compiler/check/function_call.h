// Calls of the functions that a task declares.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/conversion.h"
#include "compiler/check/task_scope.h"

namespace compiler {

// `arguments` are fitted to the parameters as assigned values are. A function of single values is
// applied to each element of vectors, matrices and arrays. Reports mistakes and then
// returns nothing.
std::optional<CheckedExpression> CheckFunctionCall(const FunctionSignature& function, Span span,
                                                   std::vector<Operand> arguments,
                                                   const TaskScope& scope);

}  // namespace compiler
