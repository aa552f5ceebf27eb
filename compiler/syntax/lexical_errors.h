// Tokens that are never well-formed.
#pragma once

#include <antlr4-runtime.h>

#include "compiler/syntax/syntax_report.h"

namespace compiler {

enum class Repair {
  kKeep,      // the token is well-formed, or what was probably meant
  kLeaveOut,  // the token means nothing
  kSkipLine   // nor does the rest of its line
};

// Reports the error if the token is one of those (unknown characters, unclosed texts, operators of
// other languages) and turns it into what was probably meant. `last`: the token before it, or null.
Repair RepairToken(antlr4::CommonToken& token, const antlr4::Token* last, SyntaxReport& report);

// The end of the text in the string that is not closed: braces at the end of its line are none.
uint32_t EndOfUnclosedString(Span span, const SourceFile& source);

}  // namespace compiler
