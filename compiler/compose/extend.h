// A task merged with the one that it extends.
#pragma once

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// The declarations of `base`, changed by the overrides of `own`, then those that `own` adds; the
// header is that of `own`. The base's tests are left out. All mistakes go to `diagnostics`.
SyntaxTree Extend(SyntaxTree base, SyntaxTree own, Diagnostics& diagnostics);

// The same for a base of which nothing is known.
SyntaxTree ExtendUnknown(SyntaxTree own);

// Reports the overrides of a task that extends none. False if there are none.
bool RejectOverrides(const SyntaxTree& tree, Diagnostics& diagnostics);

// Adds what one tree has lost to what another one has.
void AddLost(LostText more, LostText& lost);

}  // namespace compiler
