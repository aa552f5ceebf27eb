// Potentials: `reward potential near = -norm(base.position.xy) / 1 m`.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Adds each as a term, with the memory that it lives in and the statements that pay it, behind the
// task's own blocks: what those set counts for the state that is reached. Precondition: the events
// have been checked.
void CheckPotentials(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);

}  // namespace compiler
