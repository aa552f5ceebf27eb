#include "compiler/check/constant_value.h"

#include <utility>

#include "compiler/check/apply.h"

namespace compiler {
namespace {

class ConstantEvaluator {
 public:
  explicit ConstantEvaluator(const std::vector<CheckedConst>& consts) : consts_(consts) {}

  std::optional<Value> Evaluate(const CheckedExpression& expression) const {
    return std::visit([&](const auto& node) { return Of(node, expression.type); }, expression.node);
  }

 private:
  using Result = std::optional<Value>;

  Result Of(const Constant& node, const Type& type) const {
    return Filled(type.scalar, 1, node.value);
  }

  Result Of(const ConstRead& node, const Type& type) const {
    return MakeValue(type.scalar, consts_[node.index].elements);
  }

  Result Of(const Elements& node, const Type&) const {
    const Result operand = Evaluate(*node.operand);
    return operand ? Result(Pick(*operand, node.indices)) : std::nullopt;
  }

  Result Of(const CheckedUnary& node, const Type&) const {
    Result operand = Evaluate(*node.operand);
    return operand ? Result(Apply(node.op, std::move(*operand))) : std::nullopt;
  }

  Result Of(const CheckedBinary& node, const Type& type) const {
    const Result left = Evaluate(*node.left);
    const Result right = Evaluate(*node.right);
    return left && right ? Result(Apply(node.op, *left, *right, type.size())) : std::nullopt;
  }

  Result Of(const BuiltinCall& node, const Type& type) const {
    std::vector<Value> arguments;
    for (const CheckedExpressionPtr& argument : node.arguments) {
      Result value = Evaluate(*argument);
      if (!value) return std::nullopt;
      arguments.push_back(std::move(*value));
    }
    return Apply(node.function, arguments, type);
  }

  Result Of(const IntToReal& node, const Type&) const {
    const Result operand = Evaluate(*node.operand);
    return operand ? Result(ToReals(*operand)) : std::nullopt;
  }

  // Everything else is read while the task runs.
  template <typename Node>
  Result Of(const Node&, const Type&) const {
    return std::nullopt;
  }

  const std::vector<CheckedConst>& consts_;
};

}  // namespace

std::optional<Value> ConstantValueOf(const CheckedExpression& expression,
                                     const std::vector<CheckedConst>& consts) {
  return ConstantEvaluator(consts).Evaluate(expression);
}

}  // namespace compiler
