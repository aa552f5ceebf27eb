// A short expression as text, for what a message proposes to write.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// The names of `base.velocity.xy`; empty for anything else than a name with members.
std::vector<Identifier> PathOf(const Expression& expression);

// Names, members, integers, and indices made of these; nothing for what is longer.
std::optional<std::string> WrittenForm(const Expression& expression);
// The same with commas between them.
std::optional<std::string> WrittenForm(const std::vector<ExpressionPtr>& expressions);

}  // namespace compiler
