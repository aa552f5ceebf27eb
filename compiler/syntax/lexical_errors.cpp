#include "compiler/syntax/lexical_errors.h"

#include <TaskLexer.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/text/utf8.h"
#include "compiler/syntax/power_help.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskLexer;

constexpr TokenType kNothing = antlr4::Token::INVALID_TYPE;

struct ForeignSign {
  std::string_view text;
  TokenType meant;  // exactly; kNothing where the line cannot be read
  std::string_view help;
  std::string_view instead = "";  // what takes its place; empty where more has to change
};
constexpr std::array<ForeignSign, 18> kForeignSigns = {{
    {"&&", TaskLexer::AND, "write `and`", "and"},
    {"&", TaskLexer::AND, "write `and`", "and"},
    {"||", TaskLexer::OR, "write `or`", "or"},
    {"|", TaskLexer::OR, "write `or`", "or"},
    {"!", TaskLexer::NOT, "write `not`", "not"},
    {"~", TaskLexer::NOT, "write `not`", "not"},
    {"<>", TaskLexer::NOT_EQUAL, "write `!=`", "!="},
    {"~=", TaskLexer::NOT_EQUAL, "write `!=`", "!="},
    {"!==", TaskLexer::NOT_EQUAL, "write `!=`", "!="},
    {"===", TaskLexer::EQUAL, "write `==`", "=="},
    {"=<", TaskLexer::LESS_EQUAL, "write `<=`", "<="},
    {"=>", TaskLexer::GREATER_EQUAL, "write `>=`", ">="},
    {":=", TaskLexer::ASSIGN, "write `=`", "="},
    {".*", TaskLexer::TIMES, "`*` is element by element already", "*"},
    {"./", TaskLexer::DIVIDE, "`/` is element by element already", "/"},
    {"++", kNothing, "write `x += 1`", " += 1"},
    {"@", kNothing,
     "a vector is rotated by `rotate(m, v)`; the product of two vectors is `dot(v, w)`"},
    {"%", kNothing, "there is no remainder and no percentage: write `0.05` for 5 percent"},
}};

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

// `|x|`: bars where an operand begins, up to the next ones in the line. False: they are none.
bool RejectBars(const antlr4::CommonToken& token, const std::string& sign,
                const antlr4::Token* last, SyntaxReport& report) {
  const Span open = SpanOf(token);
  const bool is_operator =
      last != nullptr && EndsOperand(last->getType()) && last->getLine() == token.getLine();
  if (is_operator) return false;
  const SourceFile& source = report.source();
  const std::string_view line = source.Line(source.LineOf(open.begin));
  const uint32_t start = source.LineStart(source.LineOf(open.begin));
  const size_t close = line.find(sign, open.end - start);
  if (close == std::string_view::npos) return false;
  const Span whole{open.begin, start + static_cast<uint32_t>(close + sign.size())};
  const std::string inside(line.substr(open.end - start, close - (open.end - start)));
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, whole,
                     fmt::format("`{0}...{0}` is not part of the task language", sign));
  diagnostic.help = {"the magnitude of a number is `abs(x)`, the length of a vector `norm(v)`",
                     {{whole, "abs(" + inside + ")"}, {whole, "norm(" + inside + ")"}}};
  report.Add(std::move(diagnostic));
  return true;
}

bool IsFirstInLine(Span span, const SourceFile& source) {
  const uint32_t start = source.LineStart(source.LineOf(span.begin));
  return source.TextOf({start, span.begin}).find_first_not_of(" \t") == std::string_view::npos;
}

Repair RejectForeignComment(const antlr4::CommonToken& token, const std::string& text,
                            SyntaxReport& report) {
  const uint32_t begin = SpanOf(token).begin;
  const std::string sign = text.substr(0, 1);
  const bool is_include = text.starts_with("#include");
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, {begin, begin + 1},
                     fmt::format("`{}` is not part of the task language", sign));
  diagnostic.help = is_include ? Help("a library is imported with `import \"NAME.task\"`")
                               : Help("a comment begins with `//`", {{diagnostic.span, "//"}});
  report.AddMended(std::move(diagnostic));
  return Repair::kSkipLine;
}

// The choice `c ? x : y`, as far as it goes.
Repair RejectChoice(const antlr4::CommonToken& token, SyntaxReport& report) {
  Diagnostic diagnostic =
      MakeDiagnostic(code::kForeignSyntax, SpanOf(token), "`? :` is not part of the task language");
  diagnostic.help = "write `select(condition, x, y)`: `x` where the condition holds, else `y`";
  report.Add(std::move(diagnostic));
  report.IgnoreLine(SpanOf(token));
  return Repair::kLeaveOut;
}

Diagnostic ForeignSignMessage(Span span, std::string_view text, Help help) {
  Diagnostic diagnostic = MakeDiagnostic(
      code::kForeignSyntax, span, fmt::format("`{}` is not part of the task language", text));
  diagnostic.help = std::move(help);
  return diagnostic;
}

Repair RepairForeignSign(antlr4::CommonToken& token, const std::string& text,
                         const antlr4::Token* last, SyntaxReport& report) {
  const Span span = SpanOf(token);
  const SourceFile& source = report.source();
  if (text == "%" && IsFirstInLine(span, source)) return RejectForeignComment(token, text, report);
  if (text == "?") return RejectChoice(token, report);
  const bool is_bar = text == "|" || text == "||";
  if (is_bar && RejectBars(token, text, last, report)) {
    report.IgnoreLine(span);
    return Repair::kLeaveOut;
  }
  if (text == "**" || text == ".^") {
    report.Add(ForeignSignMessage(span, text, HelpForPower(source, span)));
    token.setType(TaskLexer::TIMES);
    return Repair::kKeep;
  }
  if (text == ";") {
    report.AddMended(ForeignSignMessage(
        span, text, {"remove it: a statement ends at the end of its line", {{span, ""}}}));
    return Repair::kLeaveOut;
  }
  const auto* sign = std::ranges::find(kForeignSigns, text, &ForeignSign::text);
  Diagnostic diagnostic =
      ForeignSignMessage(span, text, {std::string(sign->help), FixesOf(*sign, span, source)});
  token.setType(sign->meant);
  if (sign->meant == kNothing) {
    report.Add(std::move(diagnostic));
    return Repair::kLeaveOut;
  }
  // `x := 3` may declare it.
  if (sign->meant == TaskLexer::ASSIGN) {
    report.Add(std::move(diagnostic));
    return Repair::kKeep;
  }
  report.AddMended(std::move(diagnostic));
  return Repair::kKeep;
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

bool IsInOtherEncoding(SyntaxReport& report) {
  const std::string_view text = report.source().text();
  const auto begins = [&](std::string_view bytes) { return text.starts_with(bytes); };
  using namespace std::string_view_literals;
  std::string_view encoding;
  if (begins("\xFF\xFE\0\0"sv) || begins("\0\0\xFE\xFF"sv)) {
    encoding = "UTF-32";
  } else if (begins("\xFF\xFE"sv) || begins("\xFE\xFF"sv) ||
             (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0'))) {
    encoding = "UTF-16";
  }
  if (encoding.empty()) return false;
  const uint32_t begin = report.source().first_offset();
  Diagnostic diagnostic = MakeDiagnostic(code::kInvalidUtf8, {begin, begin},
                                         fmt::format("the file is in {}, not in UTF-8", encoding));
  diagnostic.help = "save the file in the encoding UTF-8";
  report.Add(std::move(diagnostic));
  return true;
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
