// The text of a part of a file as `taskc fmt` sets it, whatever line breaks and comments are in it.
#pragma once

#include <antlr4-runtime.h>

#include <string>

namespace compiler {

// Precondition: it is well-formed.
std::string OneLineText(antlr4::ParserRuleContext& context);

}  // namespace compiler
