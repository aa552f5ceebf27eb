#include "compiler/check/draws.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/fold.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

constexpr size_t kMostChoices = 8;

// Calls `visit` for what is combined element by element.
template <typename ExpressionType, typename Visit>
void ForEachOperand(ExpressionType& value, const Visit& visit) {
  const auto operand = [&](const CheckedExpressionPtr& pointer) {
    visit(static_cast<ExpressionType&>(*pointer));
  };
  if (const auto* unary = std::get_if<CheckedUnary>(&value.node)) operand(unary->operand);
  if (const auto* conversion = std::get_if<IntToReal>(&value.node)) operand(conversion->operand);
  if (const auto* binary = std::get_if<CheckedBinary>(&value.node)) {
    operand(binary->left);
    operand(binary->right);
  }
  if (const auto* draw = std::get_if<Draw>(&value.node))
    for (const CheckedExpressionPtr& argument : draw->arguments) operand(argument);
  const auto* call = std::get_if<BuiltinCall>(&value.node);
  if (call != nullptr && IsElementwise(call->function))
    for (const CheckedExpressionPtr& argument : call->arguments) operand(argument);
}

const DrawDescription& Describe(std::string_view name) {
  return *std::ranges::find(kDraws, name, &DrawDescription::name);
}

bool CheckCount(const DrawDescription& draw, Span span, size_t count, Diagnostics& diagnostics) {
  const size_t most = draw.distribution == Distribution::kChoice ? kMostChoices : 2;
  if (count >= 2 && count <= most) return true;
  Report(diagnostics, code::kWrongArgumentCount, span,
         fmt::format("`{}` takes {} arguments, not {}", draw.name,
                     most == 2 ? "2" : fmt::format("2 to {}", most), count),
         {.help = fmt::format("write `{}`", draw.usage)});
  return false;
}

// What all arguments become: the type and unit of the first that is no mere 0, and a `real` unless
// whole values are chosen from.
CheckedExpression ModelOf(const DrawDescription& draw, const std::vector<Operand>& arguments) {
  const auto first = std::ranges::find_if(
      arguments, [](const Operand& argument) { return !IsLiteralZero(argument.syntax); });
  const CheckedExpression& model =
      first == arguments.end() ? arguments.front().expression : first->expression;
  const bool has_reals = std::ranges::any_of(arguments, [](const Operand& argument) {
    return argument.expression.type.scalar == Scalar::kReal;
  });
  Type type = model.type;
  const bool is_choice = draw.distribution == Distribution::kChoice;
  if (type.scalar == Scalar::kInt && (has_reals || !is_choice)) type.scalar = Scalar::kReal;
  return {model.span, type, model.unit, Constant{}};
}

bool CheckNumbers(const DrawDescription& draw, const std::vector<Operand>& arguments,
                  Diagnostics& diagnostics) {
  for (const Operand& argument : arguments) {
    const CheckedExpression& value = argument.expression;
    if (IsNumber(value.type) && (IsScalar(value.type) || IsRow(value.type))) continue;
    Report(diagnostics, code::kWrongArgument, value.span,
           fmt::format("`{}` needs numbers", draw.name),
           {.note = fmt::format("this is {}", WithArticle(value.type)),
            .help = "`choose` takes values of any type"});
    return false;
  }
  return true;
}

// What is known to be senseless before the run.
bool CheckValues(const DrawDescription& draw, const std::vector<CheckedExpressionPtr>& arguments,
                 Span span, Diagnostics& diagnostics) {
  const auto first = ValueOf(*arguments[0]);
  const auto second = ValueOf(*arguments[1]);
  if (draw.distribution == Distribution::kUniform && first && second && *first > *second) {
    Report(diagnostics, code::kBadDraw, span, "the range is empty",
           {.help = "write the smaller end first"});
    return false;
  }
  if (draw.distribution == Distribution::kNormal && second && *second < 0) {
    Report(diagnostics, code::kBadDraw, arguments[1]->span,
           "a standard deviation is never negative");
    return false;
  }
  return true;
}

// Does the scalar follow element by element from random numbers?
bool IsDrawn(const CheckedExpression& value) {
  if (!IsScalar(value.type)) return false;
  if (std::holds_alternative<Draw>(value.node)) return true;
  bool is_drawn = false;
  ForEachOperand(
      value, [&](const CheckedExpression& operand) { is_drawn = is_drawn || IsDrawn(operand); });
  return is_drawn;
}

// Gives a scalar that is drawn the shape of `type`.
void Widen(CheckedExpression& value, const Type& type) {
  const Scalar scalar = value.type.scalar;
  value.type = type;
  value.type.scalar = scalar;
  ForEachOperand(value, [&](CheckedExpression& operand) {
    if (IsDrawn(operand)) Widen(operand, type);
  });
}

void DrawEach(CheckedExpression& value) {
  ForEachOperand(value, [&](CheckedExpression& operand) {
    if (!IsScalar(value.type) && IsDrawn(operand)) Widen(operand, value.type);
  });
  ForEachPart(value, [&](CheckedExpression& part) {
    if (&part != &value) DrawEach(part);
  });
}

}  // namespace

bool IsDrawFunction(std::string_view name) {
  return std::ranges::find(kDraws, name, &DrawDescription::name) != std::end(kDraws);
}

void DrawEachElement(CheckedExpression& value, const Type& goal) {
  if (!IsScalar(goal) && IsDrawn(value)) Widen(value, goal);
  DrawEach(value);
}

std::optional<CheckedExpression> CheckDraw(const Identifier& function, Span span,
                                           std::vector<Operand> arguments, uint32_t& count,
                                           Diagnostics& diagnostics) {
  const DrawDescription& draw = Describe(function.text);
  if (!CheckCount(draw, span, arguments.size(), diagnostics)) return std::nullopt;
  const bool is_choice = draw.distribution == Distribution::kChoice;
  if (!is_choice && !CheckNumbers(draw, arguments, diagnostics)) return std::nullopt;
  const CheckedExpression model = ModelOf(draw, arguments);
  std::vector<CheckedExpressionPtr> converted;
  for (Operand& argument : arguments) {
    auto value =
        ConvertTo(std::move(argument), model.type, model.unit, fmt::format("`{}`", draw.name),
                  diagnostics, {{model.span, "as this one"}});
    if (!value) return std::nullopt;
    converted.push_back(std::make_unique<CheckedExpression>(std::move(*value)));
  }
  if (!CheckValues(draw, converted, span, diagnostics)) return std::nullopt;
  return CheckedExpression{span, model.type, model.unit,
                           Draw{draw.distribution, count++, std::move(converted)}};
}

}  // namespace compiler
