#include "compiler/syntax/foreign_signs.h"

#include <TaskLexer.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "compiler/syntax/power_help.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskLexer;

constexpr TokenType kUnreadable = antlr4::Token::INVALID_TYPE;

struct ForeignSign {
  std::string_view text;
  TokenType meant;  // exactly; kUnreadable where the line cannot be read
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
    {"++", kUnreadable, "write `x += 1`", " += 1"},
    {"@", kUnreadable,
     "a vector is rotated by `rotate(m, v)`; the product of two vectors is `dot(v, w)`"},
    {"%", kUnreadable, "there is no remainder and no percentage: write `0.05` for 5 percent"},
}};

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

}  // namespace

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
  if (sign->meant == kUnreadable) {
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

}  // namespace compiler
