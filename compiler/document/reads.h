// What an expression reads, by the names that its author wrote.
#pragma once

#include <string>
#include <vector>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Adds each name once, in the order of the text, and as far as it leads: of
// `weight * norm(base.velocity.xy) + joint.angle[arms, head]` it is "weight", "base.velocity.xy"
// and "joint.angle". What an index picks by is not read.
void AddReads(const Expression& expression, std::vector<std::string>& reads);

std::vector<std::string> ReadsOf(const Expression& expression);

}  // namespace compiler
