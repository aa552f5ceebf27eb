// What is well-formed, and still hardly meant.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Looks at a task without errors. `tree` is what it was checked from.
void Warn(const CheckedTask& task, const SyntaxTree& tree, Diagnostics& diagnostics);

}  // namespace compiler
