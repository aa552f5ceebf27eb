// What a file must consist of before anything is made of it.
#pragma once

#include "compiler/syntax/syntax_report.h"

namespace compiler {

// Reports a file in UTF-16 or UTF-32, which cannot be read any further, and returns true.
bool IsInOtherEncoding(SyntaxReport& report);

// Reports the first place that is not UTF-8, or that holds a character which a reader cannot see:
// then a file can read differently from what is compiled. Tabs and line ends are fine.
void CheckCharacters(SyntaxReport& report);

}  // namespace compiler
