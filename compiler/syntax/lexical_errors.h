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

// Reports a file in UTF-16 or UTF-32, which cannot be read any further, and returns true.
bool IsInOtherEncoding(SyntaxReport& report);

// Reports the first place that is not UTF-8, or that holds a character which a reader cannot see:
// then a file can read differently from what is compiled. Tabs and line ends are fine.
void CheckCharacters(SyntaxReport& report);

}  // namespace compiler
