#include "compiler/syntax/unit_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <vector>

#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskParser;

constexpr int kMaxPower = 9;
// Up to here every integer is a real number, too.
constexpr double kMaxInteger = 9007199254740992.0;  // 2^53

void ReportNumber(SyntaxReport& report, Span span, std::string message, Help help) {
  Diagnostic diagnostic = MakeDiagnostic(code::kBadNumber, span, std::move(message));
  diagnostic.help = std::move(help);
  report.AddMended(std::move(diagnostic));
}

// Nothing after a message.
std::optional<int> BuildPower(TaskParser::UnitFactorContext& context, SyntaxReport& report) {
  if (context.power == nullptr) return 1;
  const std::string text = context.power->getText();
  int power = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, power);
  if (result.ec != std::errc() || result.ptr != end || power > kMaxPower) {
    ReportNumber(report, SpanOf(*context.power), fmt::format("`{}` is not a power of a unit", text),
                 "a power is an integer from -9 to 9");
    return std::nullopt;
  }
  return context.minus != nullptr ? -power : power;
}

// Factors and the operators between them, as the children of a unit stand in the tree.
UnitExpression BuildFactors(antlr4::ParserRuleContext& context, SyntaxReport& report) {
  UnitExpression unit{{}, SpanOf(context)};
  bool is_divisor = false;
  for (antlr4::tree::ParseTree* child : context.children) {
    if (auto* op = dynamic_cast<TaskParser::UnitOperatorContext*>(child)) {
      is_divisor = op->getStart()->getType() == TaskParser::DIVIDE;
    } else if (auto* factor = dynamic_cast<TaskParser::UnitFactorContext*>(child)) {
      const auto power = BuildPower(*factor, report);
      unit.is_lost = unit.is_lost || !power;
      const Identifier name = factor->unitName() != nullptr
                                  ? BuildName(*factor->unitName())
                                  : BuildName(*factor->ANY_UNIT()->getSymbol());
      unit.factors.push_back({name, is_divisor ? -power.value_or(1) : power.value_or(1)});
      is_divisor = false;
    }
  }
  return unit;
}

}  // namespace

Span SpanOf(antlr4::ParserRuleContext& context) {
  return Cover(SpanOf(*context.getStart()), SpanOf(*context.getStop()));
}

Identifier BuildName(antlr4::Token& token) { return {token.getText(), SpanOf(token)}; }

Identifier BuildName(antlr4::ParserRuleContext& context) {
  return {context.getText(), SpanOf(context)};
}

std::string BuildText(antlr4::Token& token, SyntaxReport& report) {
  const Span span = SpanOf(token);
  const std::string_view written = report.source().TextOf(span);
  std::string text;
  for (uint32_t i = 1; i + 1 < written.size(); ++i) {
    if (written[i] == '\\') {
      ++i;
      if (written[i] != '"' && written[i] != '\\') {
        Diagnostic diagnostic =
            MakeDiagnostic(code::kUnknownEscape, {span.begin + i - 1, span.begin + i + 1},
                           "there is no such escape sequence");
        diagnostic.help = "a string has only the escapes `\\\"` and `\\\\`";
        report.AddMended(std::move(diagnostic));
      }
    }
    text += written[i];
  }
  return text;
}

std::string BuildNeededText(antlr4::Token& token, const char* need, SyntaxReport& report) {
  std::string text = BuildText(token, report);
  if (text.empty()) {
    Diagnostic diagnostic = MakeDiagnostic(code::kEmptyText, SpanOf(token), need);
    diagnostic.help = "write it between the quotes";
    report.AddUnlessFaulty(std::move(diagnostic));
  }
  return text;
}

TypeExpression BuildType(TaskParser::TypeContext& context) {
  TypeExpression type{BuildName(*context.name(0)), std::nullopt, {}};
  type.span = type.name.span;
  if (context.index != nullptr) type.index = BuildName(*context.index);
  if (context.length != nullptr) type.index = BuildName(*context.length);
  if (type.index) type.span = Cover(type.span, SpanOf(*context.RIGHT_BRACKET(0)->getSymbol()));
  return type;
}

std::optional<UnitExpression> BuildUnitOf(TaskParser::TypeContext& context, UnitOwner owner,
                                          SyntaxReport& report) {
  if (context.unit() == nullptr) return std::nullopt;
  UnitExpression unit = BuildUnit(*context.unit(), report);
  const auto any = std::ranges::find(unit.factors, kAnyUnit,
                                     [](const UnitFactor& factor) { return factor.name.text; });
  if (owner == UnitOwner::kFunction || any == unit.factors.end()) return unit;
  Diagnostic diagnostic =
      MakeDiagnostic(code::kOpenUnit, any->name.span,
                     "only the parameters and the result of a function leave their unit open");
  diagnostic.help = "write the unit: `[m/s]`";
  report.AddMended(std::move(diagnostic));
  unit.is_lost = true;
  return unit;
}

UnitExpression BuildUnit(TaskParser::UnitContext& context, SyntaxReport& report) {
  UnitExpression unit = BuildFactors(context, report);
  if (context.one != nullptr && context.one->getText() != "1") {
    ReportNumber(report, SpanOf(*context.one), "a unit has no factor but 1",
                 "write the inverse of a unit as `1/s`");
    unit.is_lost = true;
  }
  return unit;
}

std::optional<NumberLiteral> BuildNumber(TaskParser::NumberContext& context, SyntaxReport& report) {
  antlr4::Token& token = *context.NUMBER()->getSymbol();
  const std::string text = token.getText();
  NumberLiteral number;
  number.is_integer = text.find_first_of(".eE") == std::string::npos;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number.value);
  if (result.ec == std::errc::result_out_of_range) {
    ReportNumber(report, SpanOf(token), "this number is too large or too close to 0",
                 "a number is 0 or lies between 2.3e-308 and 1.7e308");
    return std::nullopt;
  }
  if (number.is_integer && number.value > kMaxInteger) {
    ReportNumber(
        report, SpanOf(token), "this integer is too large",
        {fmt::format("write it as a real number: `{}.0`", text), {{SpanOf(token), text + ".0"}}});
    return std::nullopt;
  }
  if (auto* unit = context.literalUnit()) number.unit = BuildFactors(*unit, report);
  return number;
}

}  // namespace compiler
