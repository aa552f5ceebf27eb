#include "compiler/interpret/blame.h"

#include <taskc/largest_reward.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/check/traversal.h"
#include "compiler/interpret/expression_evaluator.h"

namespace compiler {
namespace {

bool IsWrong(const Value& value) {
  const auto* reals = std::get_if<Reals>(&value);
  return reals != nullptr && std::ranges::any_of(*reals, [](double real) {
           return !(std::abs(real) <= TASKC_LARGEST_REWARD);
         });
}

using Expressions = std::vector<const CheckedExpression*>;

Expressions OperandsOf(const CheckedExpression& expression) {
  Expressions operands;
  ForEachDirectPart(expression, [&](const CheckedExpression& part) { operands.push_back(&part); });
  return operands;
}

}  // namespace

Blame ExpressionEvaluator::BlameFor(const CheckedExpression& expression,
                                    const LetValues& lets) const {
  for (const CheckedExpression* operand : OperandsOf(expression)) {
    if (IsWrong(Evaluate(*operand))) return BlameFor(*operand, lets);
  }
  if (const auto* read = std::get_if<LocalRead>(&expression.node)) {
    const CheckedExpression* let = lets[read->local];
    if (let != nullptr && IsWrong(Evaluate(*let))) return BlameFor(*let, lets);
  }
  if (const auto* call = std::get_if<FunctionCall>(&expression.node)) {
    return BlameInside(*call, expression.type);
  }
  Blame blame{&expression, Evaluate(expression), {}};
  for (const CheckedExpression* operand : OperandsOf(expression)) {
    if (const auto* whole = std::get_if<IntToReal>(&operand->node)) operand = whole->operand.get();
    if (std::holds_alternative<Constant>(operand->node)) continue;
    blame.operands.push_back({operand, Evaluate(*operand)});
  }
  return blame;
}

// In the body of a function, of which the arguments are right.
Blame ExpressionEvaluator::BlameInside(const FunctionCall& call, const Type& type) const {
  const CheckedFunction& function = task_.functions[call.function];
  std::vector<Value> arguments = EvaluateAll(call.arguments);
  for (uint32_t i = 0; call.is_each && i < type.size(); ++i) {
    std::vector<Value> elements;
    for (const Value& each : arguments) {
      elements.push_back(SizeOf(each) == 1 ? each : Pick(each, {i}));
    }
    if (i + 1 < type.size() && !IsWrong(Call(function, elements))) continue;
    arguments = std::move(elements);
    break;
  }
  std::vector<Value> locals(function.locals.size());
  LetValues lets(function.locals.size());
  const ExpressionEvaluator inside(task_, frame_, locals, arguments, {});
  for (const CheckedLet& let : function.lets) {
    locals[let.local] = inside.Evaluate(let.value);
    lets[let.local] = &let.value;
  }
  return inside.BlameFor(function.value, lets);
}

}  // namespace compiler
