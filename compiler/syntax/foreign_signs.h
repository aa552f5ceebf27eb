// Signs of other languages.
#pragma once

#include <antlr4-runtime.h>

#include <string>

#include "compiler/syntax/lexical_errors.h"

namespace compiler {

// For tokens of the kind FOREIGN. Reports the sign, and turns it into what was probably meant.
// `text`: of the token; `last`: the one before it, or null.
Repair RepairForeignSign(antlr4::CommonToken& token, const std::string& text,
                         const antlr4::Token* last, SyntaxReport& report);

// A comment that begins with another sign than `//`.
Repair RejectForeignComment(const antlr4::CommonToken& token, const std::string& text,
                            SyntaxReport& report);

}  // namespace compiler
