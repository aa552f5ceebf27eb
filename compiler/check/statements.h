// The blocks of the events.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Checks every `on EVENT { ... }`; adds events, reward terms and ends to the task.
void CheckEvents(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);

}  // namespace compiler
