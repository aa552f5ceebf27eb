#include "compiler/syntax/lexical_errors.h"

#include <TaskLexer.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/text/utf8.h"
#include "compiler/syntax/foreign_signs.h"
#include "compiler/syntax/power_help.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskLexer;

constexpr TokenType kNothing = antlr4::Token::INVALID_TYPE;

// A character that looks like a sign of the language, or like what is written otherwise here.
struct Lookalike {
  char32_t value;
  std::string_view meant;
  TokenType type = kNothing;  // exactly, where that is a single token
};
constexpr std::array<Lookalike, 17> kLookalikes = {{{0x00A0, " "},
                                                    {0x00B0, " deg"},
                                                    {0x00B2, "^2"},
                                                    {0x00B3, "^3"},
                                                    {0x00B5, "u"},
                                                    {0x00B7, "*", TaskLexer::TIMES},
                                                    {0x00D7, "*", TaskLexer::TIMES},
                                                    {0x00F7, "/", TaskLexer::DIVIDE},
                                                    {0x03C0, "pi"},
                                                    {0x2013, "-", TaskLexer::MINUS},
                                                    {0x201C, "\""},
                                                    {0x201D, "\""},
                                                    {0x2192, "->", TaskLexer::ARROW},
                                                    {0x2212, "-", TaskLexer::MINUS},
                                                    {0x2260, "!=", TaskLexer::NOT_EQUAL},
                                                    {0x2264, "<=", TaskLexer::LESS_EQUAL},
                                                    {0x2265, ">=", TaskLexer::GREATER_EQUAL}}};

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
  const bool is_power = point.value == 0x00B2 || point.value == 0x00B3;
  if (is_power) {
    diagnostic.help = HelpForPower(source, diagnostic.span, point.value == 0x00B2 ? "2" : "3");
  } else if (point.value == 0x00B0) {
    diagnostic.help = {"write the unit `deg`", {{diagnostic.span, " deg"}}};
  } else if (point.value == '\'') {
    diagnostic.help =
        "a string is written in double quotes; rows and columns are swapped by "
        "`transpose(m)`";
  } else if (found != kLookalikes.end()) {
    diagnostic.help = DidYouMean(diagnostic.span, std::string(found->meant));
  } else if (point.value >= 0x80) {
    diagnostic.help =
        "names consist of the letters a to z, digits and underscores; "
        "comments and strings may hold any character";
  }
  return diagnostic;
}

Repair RepairString(antlr4::CommonToken& token, SyntaxReport& report) {
  const Span span = SpanOf(token);
  Diagnostic diagnostic = MakeDiagnostic(code::kUnclosedString, span, "this string is not closed");
  diagnostic.help = {"close it with `\"` on the same line", {{{span.end, span.end}, "\""}}};
  report.Add(std::move(diagnostic));
  token.setType(TaskLexer::STRING);
  return Repair::kKeep;
}

Repair RepairNumber(antlr4::CommonToken& token, const std::string& text, SyntaxReport& report) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kBadNumber, SpanOf(token), "a number begins with a digit");
  diagnostic.help = WriteInstead(SpanOf(token), "0" + text);
  report.AddMended(std::move(diagnostic));
  token.setType(TaskLexer::NUMBER);
  return Repair::kKeep;
}

Repair RepairForeignString(antlr4::CommonToken& token, const std::string& text,
                           SyntaxReport& report) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, SpanOf(token), "a string is written in double quotes");
  diagnostic.help = "write `\"...\"`";
  const std::string inside = text.substr(1, text.size() - 2);
  if (inside.find_first_of("\"\\") == std::string::npos)
    diagnostic.help.fixes = {{SpanOf(token), '"' + inside + '"'}};
  report.Add(std::move(diagnostic));
  token.setType(TaskLexer::STRING);
  return Repair::kKeep;
}

Repair RejectBlockComment(const antlr4::CommonToken& token, SyntaxReport& report) {
  const uint32_t begin = SpanOf(token).begin;
  Diagnostic diagnostic = MakeDiagnostic(code::kForeignSyntax, {begin, begin + 2},
                                         "`/*` is not part of the task language");
  diagnostic.help = "a comment begins with `//` and ends with its line";
  report.AddMended(std::move(diagnostic));
  return Repair::kLeaveOut;
}

Repair RepairCharacter(antlr4::CommonToken& token, SyntaxReport& report) {
  const SourceFile& source = report.source();
  // What is no UTF-8, or cannot be seen, has been reported as that.
  const text::CodePoint point =
      text::DecodeUtf8(source.TextOf({SpanOf(token).begin, source.end_offset()}), 0);
  if (!point.is_valid || text::IsUnprintable(point.value)) {
    report.MarkFaulty(SpanOf(token));
    return Repair::kLeaveOut;
  }
  const auto found = std::ranges::find(kLookalikes, point.value, &Lookalike::value);
  const bool is_whole = SpanOf(token).begin + point.length == SpanOf(token).end;
  const bool is_certain = found != kLookalikes.end() && found->type != kNothing && is_whole;
  Diagnostic diagnostic = UnknownCharacter(token, source);
  if (!is_certain) {
    report.Add(std::move(diagnostic));
    return Repair::kLeaveOut;
  }
  report.AddMended(std::move(diagnostic));
  token.setType(found->type);
  return Repair::kKeep;
}

}  // namespace

Repair RepairToken(antlr4::CommonToken& token, const antlr4::Token* last, SyntaxReport& report) {
  const std::string text(report.source().TextOf(SpanOf(token)));
  switch (token.getType()) {
    case TaskLexer::UNCLOSED_STRING:
      return RepairString(token, report);
    case TaskLexer::NUMBER_WITHOUT_ZERO:
      return RepairNumber(token, text, report);
    case TaskLexer::FOREIGN:
      return RepairForeignSign(token, text, last, report);
    case TaskLexer::FOREIGN_COMMENT:
      return RejectForeignComment(token, text, report);
    case TaskLexer::FOREIGN_STRING:
      return RepairForeignString(token, text, report);
    case TaskLexer::BLOCK_COMMENT:
      return RejectBlockComment(token, report);
    case TaskLexer::BEYOND_ASCII:
    case TaskLexer::UNKNOWN:
      return RepairCharacter(token, report);
    default:
      return Repair::kKeep;
  }
}

uint32_t EndOfUnclosedString(Span span, const SourceFile& source) {
  const std::string_view text = source.TextOf(span);
  const size_t last = text.find_last_not_of(" \t}");
  return span.begin + static_cast<uint32_t>(last + 1);  // there is the quotation mark
}

}  // namespace compiler
