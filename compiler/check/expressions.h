// Expressions: every name resolved, every type and unit known, constants folded.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/check/unit.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// All of these report mistakes and then return nothing; what depends on the expression is then not
// to be reported, so that one mistake gives one message.
std::optional<CheckedExpression> CheckExpression(const Expression& expression, const Place& place,
                                                 const TaskScope& scope);

// A single `bool`.
std::optional<CheckedExpression> CheckCondition(const Expression& expression, const Place& place,
                                                const TaskScope& scope);

// A single real of any unit. `owner`: what it is for, such as "a reward".
std::optional<CheckedExpression> CheckRealNumber(const Expression& expression,
                                                 std::string_view owner, const Place& place,
                                                 const TaskScope& scope);

// A unit as written; a plain number where there is none.
std::optional<ScaledUnit> CheckUnit(const std::optional<UnitExpression>& unit,
                                    Diagnostics& diagnostics);

}  // namespace compiler
