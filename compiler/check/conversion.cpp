#include "compiler/check/conversion.h"

#include <utility>

#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

// The literal below any signs, or null.
const Expression* LiteralOf(const Expression* syntax) {
  while (syntax != nullptr) {
    if (std::holds_alternative<NumberLiteral>(syntax->node)) return syntax;
    const auto* unary = std::get_if<UnaryExpression>(&syntax->node);
    const bool is_sign = unary != nullptr && unary->op == UnaryOperator::kNegate;
    syntax = is_sign ? unary->operand.get() : nullptr;
  }
  return nullptr;
}

const NumberLiteral& NumberIn(const Expression& literal) {
  return std::get<NumberLiteral>(literal.node);
}

// Does a factor behind this text concern the whole of it?
bool IsFactor(const Expression& syntax) {
  return !std::holds_alternative<UnaryExpression>(syntax.node) &&
         !std::holds_alternative<BinaryExpression>(syntax.node);
}

// A literal without a unit, where there must be one.
Help HelpForLiteral(const Expression& literal, const Unit& want) {
  const double value = NumberIn(literal).value;
  const auto with = [&](const std::string& unit) { return fmt::format("{} {}", value, unit); };
  if (IsAngle(want))
    return {fmt::format("write `{}` or `{}`", with("deg"), with("rad")),
            {{literal.span, with("deg")}, {literal.span, with("rad")}}};
  return {fmt::format("write the number with its unit: `{}`", with(ToString(want))),
          {{literal.span, with(ToString(want))}}};
}

std::string HelpForType(const Type& have, const Type& want) {
  if (IsBool(have) && IsNumber(want)) return "a `bool` is not a number: use `if`";
  if (want.scalar == Scalar::kInt && have.scalar == Scalar::kReal && IsScalar(have))
    return "an `int` never takes a fraction: declare it as `real`";
  if (IsBool(want) && IsBool(have) && IsScalar(want))
    return "reduce it with `any`, `all` or `none`";
  if (IsBool(want) && IsNumber(have) && IsScalar(have)) return "compare it, as in `x > 0`";
  return "";
}

}  // namespace

bool IsLiteralZero(const Expression* syntax) {
  const Expression* literal = LiteralOf(syntax);
  return literal != nullptr && NumberIn(*literal).value == 0 && !NumberIn(*literal).unit;
}

CheckedExpression ToReal(CheckedExpression expression) {
  if (expression.type.scalar == Scalar::kReal) return expression;
  CheckedExpression real{expression.span, expression.type, expression.unit, Constant{}};
  real.type.scalar = Scalar::kReal;
  if (const auto value = ValueOf(expression)) {
    real.node = Constant{*value};
  } else {
    real.node = IntToReal{std::make_unique<CheckedExpression>(std::move(expression))};
  }
  return real;
}

std::string NameOf(const Unit& unit) {
  return IsPlain(unit) ? "a plain number" : fmt::format("`{}`", ToString(unit));
}

Help HelpForUnit(const Unit& have, const Expression* syntax, const Unit& want) {
  const Expression* literal = LiteralOf(syntax);
  if (IsPlain(have) && literal != nullptr) return HelpForLiteral(*literal, want);
  Unit rest = have;
  rest.radian = want.radian;
  if (rest != want) return "";
  const bool divide = have.radian > want.radian;
  const int power = std::abs(have.radian - want.radian);
  const std::string factor = power == 1 ? "1 rad" : fmt::format("1 rad^{}", power);
  Help help = fmt::format("an angle is not a plain number: {} by `{}`",
                          divide ? "divide" : "multiply", factor);
  if (syntax != nullptr && IsFactor(*syntax))
    help.fixes = {{{syntax->span.end, syntax->span.end}, (divide ? " / " : " * ") + factor}};
  return help;
}

std::optional<CheckedExpression> ConvertTo(Operand value, const Type& type, const Unit& unit,
                                           const std::string& place, Diagnostics& diagnostics,
                                           const std::vector<Label>& labels) {
  CheckedExpression& expression = value.expression;
  const Type given = expression.type;
  if (type.scalar == Scalar::kReal && given.scalar == Scalar::kInt)
    expression = ToReal(std::move(expression));
  if (expression.type != type) {
    Report(diagnostics, code::kWrongType, expression.span,
           fmt::format("{} needs {}", place, WithArticle(type)),
           {.note = fmt::format("this is {}", WithArticle(given)),
            .help = HelpForType(given, type),
            .labels = labels});
    return std::nullopt;
  }
  if (IsLiteralZero(value.syntax)) expression.unit = unit;
  if (expression.unit != unit) {
    Report(
        diagnostics, code::kWrongUnit, expression.span,
        fmt::format("{} needs {}", place,
                    IsPlain(unit) ? "a plain number" : fmt::format("a value in {}", NameOf(unit))),
        {.note = fmt::format("this is {}{}", IsPlain(expression.unit) ? "" : "in ",
                             NameOf(expression.unit)),
         .help = HelpForUnit(expression.unit, value.syntax, unit),
         .labels = labels});
    return std::nullopt;
  }
  return std::move(expression);
}

}  // namespace compiler
