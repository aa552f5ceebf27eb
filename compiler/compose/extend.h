// A task merged with the one that it extends.
#pragma once

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// The declarations of `base`, changed by the overrides of `own`, then those that `own` adds; the
// header is that of `own`. The base's tests are left out. All mistakes go to `diagnostics`.
SyntaxTree Extend(SyntaxTree base, SyntaxTree own, Diagnostics& diagnostics);

// Reports the overrides of a task that extends none.
void RejectOverrides(const SyntaxTree& tree, Diagnostics& diagnostics);

}  // namespace compiler
