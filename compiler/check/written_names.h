// The names in an expression as written.
#pragma once

#include <vector>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// From left to right, without members and functions.
void CollectNames(const Expression& expression, std::vector<const Identifier*>& names);

}  // namespace compiler
