// Tables: what a task reads from files, and how it reads it.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Declares the tables of a task.
void CheckTables(const SyntaxTree& tree, TaskScope& scope);

// The function that says how long a table is, from its first argument to its last.
inline constexpr std::string_view kDuration = "duration";

// What a table's second argument can only be.
inline constexpr std::string_view kLoopWord = "loop";

// The table that a call reads, or null: it calls something else.
const Symbol* FindTable(const CallExpression& call, const TaskScope& scope);
// `gait(time)`, `gait(time, loop)`. With a constant argument it is a constant.
std::optional<CheckedExpression> CheckTableCall(const CallExpression& call, const Symbol& table,
                                                Span span, const Place& place,
                                                const TaskScope& scope);
// `duration(gait)`
std::optional<CheckedExpression> CheckDuration(const CallExpression& call, Span span,
                                               const TaskScope& scope);

}  // namespace compiler
