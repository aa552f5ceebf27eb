// What a token does in the parse tree.
#pragma once

#include <antlr4-runtime.h>

#include "compiler/syntax/written_tokens.h"

namespace compiler {

// Precondition: the part of the file around it is well-formed.
TokenRole RoleOf(antlr4::tree::TerminalNode& node);

}  // namespace compiler
