// What only a test reads: `total(TERM)`, `value(METRIC)`, `value(LOG)`,
// `observed(OBSERVATION)`.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Reports mistakes and then returns nothing.
std::optional<CheckedExpression> CheckTestRead(const CallExpression& call, Span span,
                                               const Place& place, const TaskScope& scope);

}  // namespace compiler
