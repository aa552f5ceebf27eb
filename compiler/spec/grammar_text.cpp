#include "compiler/spec/grammar_text.h"

#include <algorithm>
#include <cctype>

namespace compiler {
namespace {

bool IsOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The end of what begins with a quote or a bracket, behind what closes it.
size_t EndOfEnclosed(std::string_view text, size_t begin, char close) {
  size_t at = begin + 1;
  while (at < text.size() && text[at] != close) at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

size_t EndOfName(std::string_view text, size_t at) {
  while (at < text.size() && IsOfName(text[at])) ++at;
  return at;
}

// `->`, `..`, `+=` and single characters.
size_t EndOfSign(std::string_view text, size_t at) {
  for (const std::string_view sign : {"->", "+="})
    if (text.substr(at).starts_with(sign)) return at + sign.size();
  return at + 1;
}

}  // namespace

std::vector<GrammarToken> TokensOfGrammar(std::string_view text) {
  std::vector<GrammarToken> tokens;
  size_t last_end = 0;
  for (size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at;
      continue;
    }
    GrammarToken token;
    size_t end = at;
    if (text.substr(at).starts_with("//")) {
      token.kind = GrammarToken::kComment;
      end = std::min(text.find('\n', at), text.size());
    } else if (c == '\'') {
      token.kind = GrammarToken::kLiteral;
      end = EndOfEnclosed(text, at, '\'');
    } else if (c == '[') {
      token.kind = GrammarToken::kSet;
      end = EndOfEnclosed(text, at, ']');
    } else if (IsOfName(c)) {
      token.kind = GrammarToken::kName;
      end = EndOfName(text, at);
    } else {
      end = EndOfSign(text, at);
    }
    token.text = text.substr(at, end - at);
    token.is_apart = std::ranges::count(text.substr(last_end, at - last_end), '\n') > 1;
    tokens.push_back(std::move(token));
    last_end = at = end;
  }
  return tokens;
}

}  // namespace compiler
