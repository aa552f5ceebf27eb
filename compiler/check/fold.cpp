#include "compiler/check/fold.h"

#include <cmath>
#include <vector>

#include "compiler/check/arithmetic.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// The value of a node whose operands are constants; nothing for any other node.
struct Evaluate {
  std::optional<double> operator()(const CheckedUnary& unary) const {
    const auto value = ValueOf(*unary.operand);
    return value ? std::optional(Calculate(unary.op, *value)) : std::nullopt;
  }

  std::optional<double> operator()(const CheckedBinary& binary) const {
    const auto left = ValueOf(*binary.left);
    const auto right = ValueOf(*binary.right);
    if (left && right) return Calculate(binary.op, *left, *right);
    if (!IsScalar(binary.left->type) || !IsScalar(binary.right->type)) return std::nullopt;
    const auto known = left ? left : right;
    if (binary.op == BinaryOperator::kAnd && known == 0) return 0;
    if (binary.op == BinaryOperator::kOr && known == 1) return 1;
    return std::nullopt;
  }

  std::optional<double> operator()(const BuiltinCall& call) const {
    if (call.function == Builtin::kVector) return std::nullopt;
    std::vector<double> values;
    for (const CheckedExpressionPtr& argument : call.arguments) {
      const auto value = ValueOf(*argument);
      if (!value) return std::nullopt;
      values.push_back(*value);
    }
    return Calculate(call.function, std::span<const double>(values));
  }

  std::optional<double> operator()(const IntToReal& conversion) const {
    return ValueOf(*conversion.operand);
  }

  template <typename Node>
  std::optional<double> operator()(const Node&) const {
    return std::nullopt;
  }
};

bool DividesByZero(const CheckedExpression& expression) {
  const auto* binary = std::get_if<CheckedBinary>(&expression.node);
  return binary != nullptr && binary->op == BinaryOperator::kDivide && ValueOf(*binary->right) == 0;
}

bool IsRepresentable(double value, const Type& type) {
  if (type.scalar == Scalar::kInt) return std::abs(value) <= kLargestInt;
  return std::isfinite(value);
}

}  // namespace

std::optional<double> ValueOf(const CheckedExpression& expression) {
  const auto* constant = std::get_if<Constant>(&expression.node);
  return constant != nullptr ? std::optional(constant->value) : std::nullopt;
}

std::optional<CheckedExpression> Fold(CheckedExpression expression, Diagnostics& diagnostics) {
  if (DividesByZero(expression)) {
    Report(diagnostics, code::kDivisionByZero, expression.span, "the divisor is always 0");
    return std::nullopt;
  }
  const auto value = std::visit(Evaluate{}, expression.node);
  if (!value) return expression;
  if (!IsRepresentable(*value, expression.type)) {
    const bool is_int = expression.type.scalar == Scalar::kInt;
    Report(diagnostics, code::kNotFinite, expression.span,
           is_int ? "the value of this is too large for an `int`"
                  : "the value of this is not a finite number");
    return std::nullopt;
  }
  expression.node = Constant{*value};
  return expression;
}

}  // namespace compiler
