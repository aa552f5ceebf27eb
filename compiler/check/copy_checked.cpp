#include "compiler/check/copy_checked.h"

#include <memory>
#include <vector>

#include "compiler/check/traversal.h"

namespace compiler {
namespace {

CheckedExpressionPtr CopyOf(const CheckedExpressionPtr& expression) {
  return std::make_unique<CheckedExpression>(compiler::CopyOf(*expression));
}

std::vector<CheckedExpressionPtr> CopyOf(const std::vector<CheckedExpressionPtr>& expressions) {
  std::vector<CheckedExpressionPtr> copies;
  for (const CheckedExpressionPtr& expression : expressions) copies.push_back(CopyOf(expression));
  return copies;
}

Elements CopyOf(const Elements& node) { return {CopyOf(node.operand), node.indices}; }
CheckedUnary CopyOf(const CheckedUnary& node) { return {node.op, CopyOf(node.operand)}; }
CheckedBinary CopyOf(const CheckedBinary& node) {
  return {node.op, CopyOf(node.left), CopyOf(node.right)};
}
CheckedWithin CopyOf(const CheckedWithin& node) {
  return {CopyOf(node.left), CopyOf(node.right), CopyOf(node.tolerance), node.is_equal};
}
BuiltinCall CopyOf(const BuiltinCall& node) { return {node.function, CopyOf(node.arguments)}; }
FunctionCall CopyOf(const FunctionCall& node) { return {node.function, CopyOf(node.arguments)}; }
Draw CopyOf(const Draw& node) { return {node.distribution, node.site, CopyOf(node.arguments)}; }
IntToReal CopyOf(const IntToReal& node) { return {CopyOf(node.operand)}; }
// All others are plain values.
template <typename Node>
Node CopyOf(const Node& node) {
  return node;
}

}  // namespace

CheckedExpression CopyOf(const CheckedExpression& expression) {
  CheckedExpression copy{expression.span, expression.type, expression.unit, {}};
  std::visit([&](const auto& node) { copy.node = CopyOf(node); }, expression.node);
  return copy;
}

size_t SizeOf(const CheckedExpression& expression) {
  size_t size = 0;
  ForEachPart(expression, [&](const CheckedExpression&) { ++size; });
  return size;
}

}  // namespace compiler
