#include "compiler/syntax/lexical_errors.h"

#include <TaskLexer.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/text/utf8.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskLexer;

constexpr TokenType kNothing = antlr4::Token::INVALID_TYPE;

struct ForeignSign {
  std::string_view text;
  TokenType meant;
  std::string_view help;
  std::string_view instead = "";  // what takes its place; empty where more has to change
};
constexpr std::array<ForeignSign, 9> kForeignSigns = {{
    {"&&", TaskLexer::AND, "write `and`", "and"},
    {"||", TaskLexer::OR, "write `or`; the length of a vector is `norm(v)`", "or"},
    {"!", TaskLexer::NOT, "write `not`", "not"},
    {"<>", TaskLexer::NOT_EQUAL, "write `!=`", "!="},
    {";", kNothing, "remove it: a statement ends at the end of its line"},
    {"%", kNothing, "there is no remainder and no percentage: write `0.05` for 5 percent"},
    {"**", TaskLexer::TIMES, "write a square as a product: `x * x`"},
    {"++", TaskLexer::PLUS, "write `x += 1`"},
    {"#", kNothing, "a comment begins with `//`", "//"},
}};

struct Lookalike {
  char32_t value;
  std::string_view meant;
};
constexpr std::array<Lookalike, 12> kLookalikes = {{{0x00A0, " "},
                                                    {0x00B2, "^2"},
                                                    {0x00B3, "^3"},
                                                    {0x00B5, "u"},
                                                    {0x00B7, "*"},
                                                    {0x00D7, "*"},
                                                    {0x2013, "-"},
                                                    {0x201C, "\""},
                                                    {0x201D, "\""},
                                                    {0x2212, "-"},
                                                    {0x2264, "<="},
                                                    {0x2265, ">="}}};

std::string Named(char32_t value, std::string_view bytes) {
  const std::string number = fmt::format("U+{:04X}", static_cast<uint32_t>(value));
  if (text::IsUnprintable(value)) return number;
  const std::string shown = fmt::format("`{}`", bytes);
  return value < 0x80 ? shown : fmt::format("{} ({})", shown, number);
}

// At the first character of the token.
Diagnostic UnknownCharacter(const antlr4::Token& token, const SourceFile& source) {
  const uint32_t begin = SpanOf(token).begin;
  const text::CodePoint point = text::DecodeUtf8(source.TextOf({begin, source.end_offset()}), 0);
  const std::string_view bytes = source.TextOf({begin, begin + point.length});
  Diagnostic diagnostic = MakeDiagnostic(
      code::kUnknownCharacter, {begin, begin + point.length},
      fmt::format("the character {} has no meaning here", Named(point.value, bytes)));
  const auto found = std::ranges::find(kLookalikes, point.value, &Lookalike::value);
  if (found != kLookalikes.end()) {
    diagnostic.help = DidYouMean(diagnostic.span, std::string(found->meant));
  } else if (point.value >= 0x80) {
    diagnostic.help =
        "names consist of the letters a to z, digits and underscores; "
        "comments and strings may hold any character";
  }
  return diagnostic;
}

// A word stands apart from the names and numbers beside it.
std::string Apart(std::string_view word, Span place, const SourceFile& source) {
  const auto is_blank = [&](uint32_t begin) {
    const std::string_view beside = source.TextOf({begin, begin + 1});
    return beside.empty() || beside.find_first_of(" \t\r\n(") == 0;
  };
  std::string text;
  if (place.begin > source.first_offset() && !is_blank(place.begin - 1)) text += ' ';
  text += word;
  if (!is_blank(place.end)) text += ' ';
  return text;
}

std::vector<Fix> FixesOf(const ForeignSign& sign, Span place, const SourceFile& source) {
  if (sign.instead.empty()) return {};
  const bool is_word = sign.instead.front() >= 'a' && sign.instead.front() <= 'z';
  return {{place, is_word ? Apart(sign.instead, place, source) : std::string(sign.instead)}};
}

bool RepairForeignSign(antlr4::CommonToken& token, const std::string& text, SyntaxReport& report) {
  const auto* sign = std::ranges::find(kForeignSigns, text, &ForeignSign::text);
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, SpanOf(token),
                     fmt::format("`{}` is not part of the task language", text));
  diagnostic.help = {std::string(sign->help), FixesOf(*sign, SpanOf(token), report.source())};
  report.Add(std::move(diagnostic));
  token.setType(sign->meant);
  return sign->meant != kNothing;
}

bool RepairString(antlr4::CommonToken& token, SyntaxReport& report) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kUnclosedString, SpanOf(token), "this string is not closed");
  diagnostic.help = "close it with `\"` on the same line";
  report.Add(std::move(diagnostic));
  token.setType(TaskLexer::STRING);
  return true;
}

bool RepairNumber(antlr4::CommonToken& token, const std::string& text, SyntaxReport& report) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kBadNumber, SpanOf(token), "a number begins with a digit");
  diagnostic.help = WriteInstead(SpanOf(token), "0" + text);
  report.Add(std::move(diagnostic));
  token.setType(TaskLexer::NUMBER);
  return true;
}

bool RepairForeignString(antlr4::CommonToken& token, const std::string& text,
                         SyntaxReport& report) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, SpanOf(token), "a string is written in double quotes");
  diagnostic.help = "write `\"...\"`";
  const std::string inside = text.substr(1, text.size() - 2);
  if (inside.find_first_of("\"\\") == std::string::npos)
    diagnostic.help.fixes = {{SpanOf(token), '"' + inside + '"'}};
  report.Add(std::move(diagnostic));
  token.setType(TaskLexer::STRING);
  return true;
}

bool RejectBlockComment(const antlr4::CommonToken& token, SyntaxReport& report) {
  const uint32_t begin = SpanOf(token).begin;
  Diagnostic diagnostic = MakeDiagnostic(code::kForeignSyntax, {begin, begin + 2},
                                         "`/*` is not part of the task language");
  diagnostic.help = "a comment begins with `//` and ends with its line";
  report.Add(std::move(diagnostic));
  return false;
}

bool RejectCharacter(const antlr4::CommonToken& token, SyntaxReport& report) {
  const SourceFile& source = report.source();
  // What is no UTF-8, or cannot be seen, has been reported as that.
  const text::CodePoint point =
      text::DecodeUtf8(source.TextOf({SpanOf(token).begin, source.end_offset()}), 0);
  if (point.is_valid && !text::IsUnprintable(point.value)) {
    report.Add(UnknownCharacter(token, source));
  } else {
    report.MarkFaulty(SpanOf(token));
  }
  return false;
}

bool IsHidden(char32_t value, std::string_view behind) {
  if (value == '\r') return !behind.starts_with('\n');
  return value != '\t' && value != '\n' && text::IsUnprintable(value);
}

Diagnostic HiddenCharacter(char32_t value, Span span) {
  const bool is_control = value < 0xA0;
  Diagnostic diagnostic = MakeDiagnostic(
      code::kHiddenCharacter, span,
      fmt::format("the {} U+{:04X} cannot be seen", is_control ? "control character" : "character",
                  static_cast<uint32_t>(value)));
  if (value == '\r') {
    diagnostic.help = "end a line with a line feed, or with carriage return and line feed";
  } else if (is_control) {
    diagnostic.help = "remove it";
  } else {
    diagnostic.help =
        "remove it: with it, a file can read differently from what is compiled; letters that are "
        "written from right to left need no such character";
  }
  return diagnostic;
}

}  // namespace

bool RepairToken(antlr4::CommonToken& token, SyntaxReport& report) {
  const std::string text(report.source().TextOf(SpanOf(token)));
  switch (token.getType()) {
    case TaskLexer::UNCLOSED_STRING:
      return RepairString(token, report);
    case TaskLexer::NUMBER_WITHOUT_ZERO:
      return RepairNumber(token, text, report);
    case TaskLexer::FOREIGN:
      return RepairForeignSign(token, text, report);
    case TaskLexer::FOREIGN_STRING:
      return RepairForeignString(token, text, report);
    case TaskLexer::BLOCK_COMMENT:
      return RejectBlockComment(token, report);
    case TaskLexer::BEYOND_ASCII:
    case TaskLexer::UNKNOWN:
      return RejectCharacter(token, report);
    default:
      return true;
  }
}

void CheckCharacters(SyntaxReport& report) {
  const std::string& text = report.source().text();
  for (uint32_t i = 0; i < text.size();) {
    const text::CodePoint point = text::DecodeUtf8(text, i);
    const uint32_t begin = report.source().first_offset() + i;
    if (!point.is_valid) {
      Diagnostic diagnostic = MakeDiagnostic(code::kInvalidUtf8, {begin, begin + 1},
                                             "this byte is not part of a character");
      diagnostic.help = "save the file in the encoding UTF-8";
      return report.Add(std::move(diagnostic));
    }
    if (IsHidden(point.value, std::string_view(text).substr(i + point.length))) {
      return report.Add(HiddenCharacter(point.value, {begin, begin + point.length}));
    }
    i += point.length;
  }
}

}  // namespace compiler
