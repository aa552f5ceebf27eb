// Consts and sets: what has a name and is known before the run.
#pragma once

#include "compiler/check/task_scope.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Declares the consts and sets of a task, which may refer to each other in any order, but not in a
// circle.
void CheckConstants(const SyntaxTree& tree, TaskScope& scope);

void WarnOfUnusedConstants(const SyntaxTree& tree, const NamedConstants& constants,
                           Diagnostics& diagnostics);

}  // namespace compiler
