// The text of an ANTLR grammar in its parts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace compiler {

struct GrammarToken {
  enum Kind { kName, kLiteral, kSet, kSign, kComment };
  Kind kind = kSign;
  std::string text;       // a literal with its quotes, a set with its brackets
  bool is_apart = false;  // of a comment: an empty line comes before it
};

// All but blanks.
std::vector<GrammarToken> TokensOfGrammar(std::string_view text);

}  // namespace compiler
