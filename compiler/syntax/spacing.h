// Blanks between two tokens of a line.
#pragma once

#include "compiler/syntax/written_tokens.h"

namespace compiler {

// Does a blank stand between these two neighbors?
bool IsSpaced(TokenRole left, TokenRole right);

// May a line end between these two? It may only where a blank or an opening bracket stands.
bool MayBreak(TokenRole left, TokenRole right);

}  // namespace compiler
