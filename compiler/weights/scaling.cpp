#include "compiler/weights/scaling.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <type_traits>
#include <utility>

namespace compiler {
namespace {

using enum Scaling;

Scaling Product(Scaling left, Scaling right) {
  return left == kProportional && right == kProportional ? kOther : std::max(left, right);
}

Scaling Quotient(Scaling above, Scaling below) { return IsIndependent(below) ? above : kOther; }

// Of what follows `operand` in no simple way, as a comparison or a sine does.
Scaling Opaque(Scaling operand) { return IsIndependent(operand) ? kIndependent : kOther; }

}  // namespace

Scaling Sum(Scaling left, Scaling right) {
  if (left == right || right == kZero) return left;
  return left == kZero ? right : kOther;
}

Scaling ExpressionScaling::Of(const CheckedExpression& expression, const ScalingOfReads& reads) {
  return std::visit(
      [&]<typename Node>(const Node& node) {
        if constexpr (std::is_same_v<Node, Constant>) {
          return node.value == 0 ? kZero : kIndependent;
        } else if constexpr (std::is_same_v<Node, ParamRead>) {
          return node.param == param_ ? kProportional : kIndependent;
        } else if constexpr (std::is_same_v<Node, MemoryRead>) {
          return reads.memory[node.memory];
        } else if constexpr (std::is_same_v<Node, LocalRead>) {
          return reads.locals[node.local];
        } else if constexpr (std::is_same_v<Node, ArgumentRead>) {
          return reads.arguments[node.argument];
        } else if constexpr (std::is_same_v<Node, RewardSoFar>) {
          return reads.reward_so_far;
        } else if constexpr (std::is_same_v<Node, TableRead>) {
          return Opaque(Of(*node.operand, reads));
        } else if constexpr (requires { node.operand; }) {
          // A minus, elements, a conversion; or a `not`, of which nothing is ever paid.
          return Of(*node.operand, reads);
        } else if constexpr (std::is_same_v<Node, CheckedBinary>) {
          return OfBinary(node, reads);
        } else if constexpr (std::is_same_v<Node, BuiltinCall>) {
          return OfBuiltin(node, reads);
        } else if constexpr (std::is_same_v<Node, FunctionCall>) {
          return OfFunction(node, reads);
        } else if constexpr (std::is_same_v<Node, Draw>) {
          return Opaque(std::ranges::max(OfAll(node.arguments, reads)));
        } else {
          return kIndependent;
        }
      },
      expression.node);
}

Scaling ExpressionScaling::OfBinary(const CheckedBinary& binary, const ScalingOfReads& reads) {
  const Scaling left = Of(*binary.left, reads);
  const Scaling right = Of(*binary.right, reads);
  switch (binary.op) {
    case BinaryOperator::kAdd:
    case BinaryOperator::kSubtract:
      return Sum(left, right);
    case BinaryOperator::kMultiply:
      return Product(left, right);
    case BinaryOperator::kDivide:
      return Quotient(left, right);
    default:
      return Opaque(std::max(left, right));
  }
}

Scaling ExpressionScaling::OfBuiltin(const BuiltinCall& call, const ScalingOfReads& reads) {
  const std::vector<Scaling> arguments = OfAll(call.arguments, reads);
  const Scaling together = std::accumulate(arguments.begin(), arguments.end(), kZero, Sum);
  switch (call.function) {
    case Builtin::kSum:
    case Builtin::kVector:
      return together;
    case Builtin::kDot:
    case Builtin::kCross:
      return Product(arguments[0], arguments[1]);
    case Builtin::kSelect:
      return IsIndependent(arguments[0]) ? Sum(arguments[1], arguments[2]) : kOther;
    case Builtin::kAbs:
    case Builtin::kNorm:
    case Builtin::kMin:
    case Builtin::kMax:
    case Builtin::kClamp:
      // |p x| is p |x|, and the larger of p x and p y is p times that of x and y, unless p < 0.
      return task_.params[param_].minimum >= 0 ? together : Opaque(together);
    case Builtin::kAny:
    case Builtin::kAll:
    case Builtin::kNone:
    case Builtin::kCount:
    case Builtin::kSqrt:
    case Builtin::kExp:
    case Builtin::kLog:
    case Builtin::kTanh:
    case Builtin::kSin:
    case Builtin::kCos:
    case Builtin::kAtan2:
    case Builtin::kTan:
    case Builtin::kAsin:
    case Builtin::kAcos:
    case Builtin::kAtan:
    case Builtin::kPow:
    case Builtin::kSign:
    case Builtin::kFloor:
    case Builtin::kCeil:
    case Builtin::kRound:
      return Opaque(together);
  }
  std::abort();
}

Scaling ExpressionScaling::OfFunction(const FunctionCall& call, const ScalingOfReads& reads) {
  std::vector<Scaling> arguments = OfAll(call.arguments, reads);
  // A function computes from its arguments alone.
  const Scaling most = arguments.empty() ? kIndependent : std::ranges::max(arguments);
  if (IsIndependent(most)) return kIndependent;
  const auto [known, is_new] = results_.try_emplace({call.function, std::move(arguments)}, kOther);
  if (is_new) known->second = OfResult(task_.functions[call.function], known->first.second);
  return known->second;
}

Scaling ExpressionScaling::OfResult(const CheckedFunction& function,
                                    const std::vector<Scaling>& arguments) {
  ScalingOfReads inside{.arguments = arguments};
  inside.locals.resize(function.locals.size());
  for (const CheckedLet& let : function.lets) inside.locals[let.local] = Of(let.value, inside);
  return Of(function.value, inside);
}

std::vector<Scaling> ExpressionScaling::OfAll(const std::vector<CheckedExpressionPtr>& expressions,
                                              const ScalingOfReads& reads) {
  std::vector<Scaling> all;
  for (const CheckedExpressionPtr& expression : expressions) all.push_back(Of(*expression, reads));
  return all;
}

}  // namespace compiler
