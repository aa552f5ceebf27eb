// The tests of a task: `test "a fall is paid once" { given ... fire ... expect ... }`.
#pragma once

#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Checks every test and adds it to the task, whose events and metrics have been checked.
void CheckTests(const SyntaxTree& tree, const TaskScope& scope, CheckedTask& task);

// As a task writes it: `end_episode failure "falls down"`.
std::string EndText(EndKind kind, const std::string& reason);

}  // namespace compiler
