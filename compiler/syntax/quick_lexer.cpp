#include "compiler/syntax/quick_lexer.h"

#include <functional>
#include <map>
#include <string>

namespace compiler {
namespace {

using Text = std::u32string_view;

constexpr Text kSigns = U"=+-*/<>^:.&|!~@%?;";
constexpr Text kSingleSigns = U"()[]{},";
constexpr size_t kManySigns = 8;  // in a row: more than the grammar has

bool IsSpace(char32_t c) { return Text(U" \t\r\n\f").find(c) != Text::npos; }
bool IsDigit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool BeginsWord(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == U'_';
}

// How many characters from `begin` on are of the kind.
template <class Kind>
size_t Run(Text text, size_t begin, Kind is_of_kind) {
  size_t end = begin;
  while (end < text.size() && is_of_kind(text[end])) ++end;
  return end - begin;
}

size_t LengthOfLine(Text text) {
  return Run(text, 0, [](char32_t c) { return c != U'\r' && c != U'\n'; });
}

// What stands for itself in the grammar: keywords, units and signs.
using Literals = std::map<std::u32string, size_t, std::less<>>;

Literals FindLiterals(const antlr4::dfa::Vocabulary& vocabulary) {
  Literals literals;
  for (size_t type = 1; type <= vocabulary.getMaxTokenType(); ++type) {
    const std::string quoted = vocabulary.getLiteralName(type);  // 'task'
    if (quoted.size() > 2)
      literals.emplace(std::u32string(quoted.begin() + 1, quoted.end() - 1), type);
  }
  return literals;
}

// 0: there is none.
size_t TypeOfLiteral(Text text, const antlr4::dfa::Vocabulary& vocabulary) {
  static const Literals literals = FindLiterals(vocabulary);
  const auto found = literals.find(text);
  return found == literals.end() ? 0 : found->second;
}

size_t LengthOfNumber(Text text) {
  size_t length = Run(text, 0, IsDigit);
  if (length < text.size() && text[length] == U'.') {
    const size_t decimals = Run(text, length + 1, IsDigit);
    if (decimals > 0) length += 1 + decimals;
  }
  if (length < text.size() && (text[length] == U'e' || text[length] == U'E')) {
    size_t exponent = length + 1;
    if (exponent < text.size() && (text[exponent] == U'+' || text[exponent] == U'-')) ++exponent;
    const size_t digits = Run(text, exponent, IsDigit);
    if (digits > 0) length = exponent + digits;
  }
  return length;
}

// 0 for one with a backslash, or without an end.
size_t LengthOfString(Text text) {
  const size_t end = text.find_first_of(U"\"\\\r\n", 1);
  return end != Text::npos && text[end] == U'"' ? end + 1 : 0;
}

bool IsComment(Text text) { return text.starts_with(U"//") && !text.starts_with(U"///"); }

}  // namespace

// Several signs in a row are one only where the grammar has it; else ANTLR tells them apart.
QuickLexer::Word QuickLexer::FirstSign(Text rest) const {
  const bool is_single = kSingleSigns.find(rest[0]) != Text::npos;
  const size_t length = is_single ? 1 : Run(rest.substr(0, kManySigns), 0, [](char32_t c) {
    return kSigns.find(c) != Text::npos;
  });
  const bool begins_number =
      rest.starts_with(U'.') && rest.size() > length && IsDigit(rest[length]);
  if (length == 0 || (begins_number && length == 1)) return {};
  const size_t literal = TypeOfLiteral(rest.substr(0, length), getVocabulary());
  return literal == 0 ? Word{} : Word{literal, length};
}

QuickLexer::Word QuickLexer::First(Text rest) const {
  if (rest.empty()) return {};
  if (rest.starts_with(U"///"))
    return {DOC_COMMENT, LengthOfLine(rest), antlr4::Token::HIDDEN_CHANNEL};
  if (BeginsWord(rest[0])) {
    const size_t length = Run(rest, 0, [](char32_t c) { return BeginsWord(c) || IsDigit(c); });
    const size_t literal = TypeOfLiteral(rest.substr(0, length), getVocabulary());
    return {literal == 0 ? size_t{NAME} : literal, length};
  }
  if (IsDigit(rest[0])) return {NUMBER, LengthOfNumber(rest)};
  if (rest[0] == U'"') return {STRING, LengthOfString(rest)};
  return FirstSign(rest);
}

std::unique_ptr<antlr4::Token> QuickLexer::nextToken() {
  SkipBlanks();
  const Word word = First(bytes_.rest());
  if (word.length == 0) return TaskLexer::nextToken();
  const size_t start = bytes_.index();
  const size_t line = getLine();
  const size_t column = getCharPositionInLine();
  Advance(word.length);
  return _factory->create({this, _input}, word.type, "", word.channel, start,
                          start + word.length - 1, line, column);
}

void QuickLexer::SkipBlanks() {
  while (true) {
    const Text rest = bytes_.rest();
    const size_t length = IsComment(rest) ? LengthOfLine(rest) : Run(rest, 0, IsSpace);
    if (length == 0) return;
    Advance(length);
  }
}

// Lines and columns are counted as ANTLR does.
void QuickLexer::Advance(size_t count) {
  size_t line = getLine();
  size_t column = getCharPositionInLine();
  for (const char32_t c : bytes_.rest().substr(0, count)) {
    column = c == U'\n' ? 0 : column + 1;
    if (c == U'\n') ++line;
  }
  setLine(line);
  setCharPositionInLine(column);
  bytes_.seek(bytes_.index() + count);
}

}  // namespace compiler
