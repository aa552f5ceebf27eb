#include "compiler/interpret/expression_evaluator.h"

#include <cmath>

#include "compiler/check/apply.h"
#include "compiler/check/table_value.h"

namespace compiler {

ExpressionEvaluator::ExpressionEvaluator(const CheckedTask& task, const Frame& frame,
                                         const std::vector<Value>& locals,
                                         const std::vector<Value>& arguments, const DrawPlace& draw)
    : task_(task), frame_(frame), locals_(locals), arguments_(arguments), draw_(draw) {}

Value ExpressionEvaluator::Evaluate(const CheckedExpression& expression) const {
  return std::visit([&](const auto& node) { return Of(node, expression.type); }, expression.node);
}

Value ExpressionEvaluator::Of(const Constant& node, const Type& type) const {
  return Filled(type.scalar, 1, node.value);
}

Value ExpressionEvaluator::Of(const ConstRead& node, const Type& type) const {
  return MakeValue(type.scalar, task_.consts[node.index].elements);
}

Value ExpressionEvaluator::Of(const SensorRead& node, const Type&) const {
  return frame_.sensors[node.sensor];
}

Value ExpressionEvaluator::Of(const ParamRead& node, const Type& type) const {
  const double value = frame_.params[node.param];
  return Filled(type.scalar, 1, type.scalar == Scalar::kBool ? value != 0 : value);
}

Value ExpressionEvaluator::Of(const MemoryRead& node, const Type&) const {
  return frame_.memory[node.memory];
}

Value ExpressionEvaluator::Of(const LocalRead& node, const Type&) const {
  return locals_[node.local];
}

Value ExpressionEvaluator::Of(const ArgumentRead& node, const Type&) const {
  return arguments_[node.argument];
}

Value ExpressionEvaluator::Of(const RewardSoFar&, const Type&) const {
  return Reals{frame_.reward};
}

Value ExpressionEvaluator::Of(const TimeStep&, const Type&) const {
  return Reals{frame_.time_step};
}

Value ExpressionEvaluator::Of(const Elements& node, const Type&) const {
  return Pick(Evaluate(*node.operand), node.indices);
}

Value ExpressionEvaluator::Of(const CheckedUnary& node, const Type&) const {
  return Apply(node.op, Evaluate(*node.operand));
}

Value ExpressionEvaluator::Of(const CheckedBinary& node, const Type& type) const {
  return Apply(node.op, Evaluate(*node.left), Evaluate(*node.right), type.size());
}

Value ExpressionEvaluator::Of(const CheckedWithin& node, const Type&) const {
  const double difference = RealOf(Evaluate(*node.left)) - RealOf(Evaluate(*node.right));
  const bool is_near = std::abs(difference) <= RealOf(Evaluate(*node.tolerance));
  return Integers{is_near == node.is_equal};
}

Value ExpressionEvaluator::Of(const BuiltinCall& node, const Type& type) const {
  return Apply(node.function, EvaluateAll(node.arguments), type);
}

Value ExpressionEvaluator::Of(const FunctionCall& node, const Type& type) const {
  const CheckedFunction& function = task_.functions[node.function];
  const std::vector<Value> arguments = EvaluateAll(node.arguments);
  if (!node.is_each) return Call(function, arguments);
  Value result = Filled(type.scalar, type.size(), 0);
  for (uint32_t i = 0; i < type.size(); ++i) {
    std::vector<Value> elements;
    for (const Value& argument : arguments)
      elements.push_back(SizeOf(argument) == 1 ? argument : Pick(argument, {i}));
    Assign(AssignOperator::kSet, {i}, Call(function, elements), result);
  }
  return result;
}

Value ExpressionEvaluator::Call(const CheckedFunction& function,
                                const std::vector<Value>& arguments) const {
  std::vector<Value> locals(function.locals.size());
  const ExpressionEvaluator inside(task_, frame_, locals, arguments, {});
  for (const CheckedLet& let : function.lets) locals[let.local] = inside.Evaluate(let.value);
  return inside.Evaluate(function.value);
}

Value ExpressionEvaluator::Of(const Draw& node, const Type& type) const {
  const std::vector<Value> arguments = EvaluateAll(node.arguments);
  if (node.distribution == Distribution::kChoice) return Choice(node, type, arguments);
  const auto& first = std::get<Reals>(arguments[0]);
  const auto& second = std::get<Reals>(arguments[1]);
  const bool is_uniform = node.distribution == Distribution::kUniform;
  Reals numbers;
  for (uint32_t i = 0; i < type.size(); ++i) {
    const double a = ElementOf(first, i);
    const double b = ElementOf(second, i);
    numbers.push_back(is_uniform ? DrawUniform(draw_, i, node.site, a, b)
                                 : DrawNormal(draw_, i, node.site, a, b));
  }
  return numbers;
}

// One of the values as it is; or for each element one of several numbers.
Value ExpressionEvaluator::Choice(const Draw& node, const Type& type,
                                  const std::vector<Value>& values) const {
  const bool is_each = SizeOf(values.front()) < type.size();
  if (!is_each) return values[DrawChoice(draw_, 0, node.site, values.size())];
  Value chosen = Filled(type.scalar, type.size(), 0);
  for (uint32_t i = 0; i < type.size(); ++i)
    Assign(AssignOperator::kSet, {i}, values[DrawChoice(draw_, i, node.site, values.size())],
           chosen);
  return chosen;
}

Value ExpressionEvaluator::Of(const TableRead& node, const Type&) const {
  return ValueAt(task_.tables[node.table], RealOf(Evaluate(*node.operand)), node.repeats);
}

Value ExpressionEvaluator::Of(const TestRead& node, const Type&) const {
  switch (node.kind) {
    case TestRead::kTotal:
      return Reals{frame_.terms[node.index]};
    case TestRead::kMetric: {
      const CheckedMetric& metric = task_.metrics[node.index];
      if (metric.reduction == Reduction::kLast) return Evaluate(metric.value);
      return Reals{frame_.recorded_metrics[node.index]};
    }
    case TestRead::kLog:
      return Reals{frame_.recorded_logs[node.index]};
    case TestRead::kReward:
      return Reals{frame_.reward};
    case TestRead::kObservation:
      return Evaluate(task_.observations[node.index].value);
    case TestRead::kEnded:
      break;
  }
  return Integers{frame_.first_end >= 0 || frame_.first_violation >= 0};
}

Value ExpressionEvaluator::Of(const IntToReal& node, const Type&) const {
  return ToReals(Evaluate(*node.operand));
}

std::vector<Value> ExpressionEvaluator::EvaluateAll(
    const std::vector<CheckedExpressionPtr>& expressions) const {
  std::vector<Value> values;
  for (const CheckedExpressionPtr& expression : expressions) {
    values.push_back(Evaluate(*expression));
  }
  return values;
}

}  // namespace compiler
