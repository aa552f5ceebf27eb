#include "compiler/language_server/text_tokens.h"

#include <algorithm>
#include <array>

namespace compiler {
namespace {

constexpr std::array<std::string_view, 27> kExpectMore = {
    "+",  "-",   "*",  "/",   "=", "+=", "-=", "*=", "/=",     "<",       "<=", ">",  ">=",    "==",
    "!=", "and", "or", "not", ",", "..", "(",  "[",  "return", "require", "if", "in", "within"};

}  // namespace

TextTokens::TextTokens(std::string_view text) : text_(text), tokens_(Lex(text)) {}

std::string_view TextTokens::TextOf(size_t index) const {
  if (index >= size()) return "";
  const Span span = tokens_[index].span;
  return text_.substr(span.begin, span.end - span.begin);
}

size_t TextTokens::CountBefore(uint32_t offset) const {
  const auto after = std::ranges::partition_point(
      tokens_, [offset](const LexedToken& token) { return token.span.end <= offset; });
  return static_cast<size_t>(after - tokens_.begin());
}

bool TextTokens::IsLineBetween(size_t left, size_t right) const {
  const uint32_t begin = tokens_[left].span.end;
  return text_.substr(begin, tokens_[right].span.begin - begin).find('\n') !=
         std::string_view::npos;
}

bool TextTokens::ExpectsMore(size_t index) const {
  return std::ranges::find(kExpectMore, TextOf(index)) != kExpectMore.end();
}

bool TextTokens::IsBlockOpen(size_t index) const {
  return Is(index, "{") && index > 0 && !ExpectsMore(index - 1);
}

}  // namespace compiler
