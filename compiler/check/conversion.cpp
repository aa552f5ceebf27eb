#include "compiler/check/conversion.h"

#include <utility>

#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

// The literal below any signs, or null.
const NumberLiteral* LiteralOf(const Expression* syntax) {
  while (syntax != nullptr) {
    if (const auto* number = std::get_if<NumberLiteral>(&syntax->node)) return number;
    const auto* unary = std::get_if<UnaryExpression>(&syntax->node);
    const bool is_sign = unary != nullptr && unary->op == UnaryOperator::kNegate;
    syntax = is_sign ? unary->operand.get() : nullptr;
  }
  return nullptr;
}

std::string HelpForType(const Type& have, const Type& want) {
  if (IsBool(have) && IsNumber(want)) return "a `bool` is no number: use `if`";
  if (want.scalar == Scalar::kInt && have.scalar == Scalar::kReal && IsScalar(have))
    return "an `int` never takes a fraction: declare it as `real`";
  if (IsBool(want) && IsBool(have) && IsScalar(want))
    return "reduce it with `any`, `all` or `none`";
  if (IsBool(want) && IsNumber(have) && IsScalar(have)) return "compare it, as in `x > 0`";
  return "";
}

}  // namespace

bool IsLiteralZero(const Expression* syntax) {
  const NumberLiteral* number = LiteralOf(syntax);
  return number != nullptr && number->value == 0 && !number->unit;
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

std::string HelpForUnit(const Unit& have, const Expression* syntax, const Unit& want) {
  const NumberLiteral* literal = LiteralOf(syntax);
  if (IsPlain(have) && literal != nullptr) {
    if (IsAngle(want)) return fmt::format("write `{0} deg` or `{0} rad`", literal->value);
    return fmt::format("write the number with its unit: `{} {}`", literal->value, ToString(want));
  }
  Unit rest = have;
  rest.radian = want.radian;
  if (rest != want) return "";
  const bool divide = have.radian > want.radian;
  const int power = std::abs(have.radian - want.radian);
  return fmt::format("an angle is no plain number: {} by `1 rad{}`", divide ? "divide" : "multiply",
                     power == 1 ? "" : fmt::format("^{}", power));
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
