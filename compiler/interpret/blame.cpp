#include "compiler/interpret/blame.h"

#include <taskc/largest_reward.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

Expressions All(const std::vector<CheckedExpressionPtr>& expressions) {
  Expressions all;
  for (const CheckedExpressionPtr& each : expressions) all.push_back(each.get());
  return all;
}

// What an expression computes with: a case for each kind.
struct Operands {
  Expressions operator()(const Constant&) const { return {}; }
  Expressions operator()(const ConstRead&) const { return {}; }
  Expressions operator()(const SensorRead&) const { return {}; }
  Expressions operator()(const ParamRead&) const { return {}; }
  Expressions operator()(const MemoryRead&) const { return {}; }
  Expressions operator()(const LocalRead&) const { return {}; }
  Expressions operator()(const ArgumentRead&) const { return {}; }
  Expressions operator()(const RewardSoFar&) const { return {}; }
  Expressions operator()(const TimeStep&) const { return {}; }
  Expressions operator()(const TestRead&) const { return {}; }
  Expressions operator()(const Elements& node) const { return {node.operand.get()}; }
  Expressions operator()(const CheckedUnary& node) const { return {node.operand.get()}; }
  Expressions operator()(const CheckedBinary& node) const {
    return {node.left.get(), node.right.get()};
  }
  Expressions operator()(const CheckedWithin& node) const {
    return {node.left.get(), node.right.get(), node.tolerance.get()};
  }
  Expressions operator()(const BuiltinCall& node) const { return All(node.arguments); }
  Expressions operator()(const FunctionCall& node) const { return All(node.arguments); }
  Expressions operator()(const Draw& node) const { return All(node.arguments); }
  Expressions operator()(const TableRead& node) const { return {node.operand.get()}; }
  Expressions operator()(const IntToReal& node) const { return {node.operand.get()}; }
};

Expressions OperandsOf(const CheckedExpression& expression) {
  return std::visit(Operands(), expression.node);
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
