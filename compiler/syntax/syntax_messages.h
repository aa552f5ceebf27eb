// What is said where the parser meets a token it did not expect.
#pragma once

#include <antlr4-runtime.h>

#include "compiler/source/diagnostic.h"

namespace compiler {

// `parser` stands in the rule that failed; `found` is the token of `file` that does not fit.
Diagnostic DescribeSyntaxError(antlr4::Parser& parser, antlr4::Token& found,
                               const SourceFile& file);

}  // namespace compiler
