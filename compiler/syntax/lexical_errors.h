// Tokens that are never well-formed.
#pragma once

#include <antlr4-runtime.h>

#include "compiler/syntax/syntax_report.h"

namespace compiler {

// Reports the error if the token is one of those (unknown characters, unclosed texts, operators of
// other languages) and turns it into what was probably meant. Returns false if nothing was: then
// the token is to be left out.
bool RepairToken(antlr4::CommonToken& token, SyntaxReport& report);

// Reports the first place that is not UTF-8, or that holds a character which a reader cannot see:
// then a file can read differently from what is compiled. Tabs and line ends are fine.
void CheckCharacters(SyntaxReport& report);

}  // namespace compiler
