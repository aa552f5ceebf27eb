#include "compiler/compose/copy_expression.h"

#include <vector>

namespace compiler {
namespace {

ExpressionPtr CopyOf(const ExpressionPtr& expression) {
  return std::make_unique<Expression>(compiler::CopyOf(*expression));
}

std::vector<ExpressionPtr> CopyOf(const std::vector<ExpressionPtr>& expressions) {
  std::vector<ExpressionPtr> copies;
  for (const ExpressionPtr& expression : expressions) copies.push_back(CopyOf(expression));
  return copies;
}

NumberLiteral CopyOf(const NumberLiteral& node) { return node; }
BoolLiteral CopyOf(const BoolLiteral& node) { return node; }
NameExpression CopyOf(const NameExpression& node) { return node; }
MethodExpression CopyOf(const MethodExpression& node) {
  return {CopyOf(node.object), node.name, node.parenthesis, CopyOf(node.arguments)};
}
LostExpression CopyOf(const LostExpression& node) { return node; }
MemberExpression CopyOf(const MemberExpression& node) { return {CopyOf(node.object), node.member}; }
IndexExpression CopyOf(const IndexExpression& node) {
  return {CopyOf(node.object), CopyOf(node.items)};
}
RangeExpression CopyOf(const RangeExpression& node) {
  return {CopyOf(node.first), CopyOf(node.last)};
}
SetExpression CopyOf(const SetExpression& node) { return {CopyOf(node.items)}; }
CallExpression CopyOf(const CallExpression& node) {
  return {node.function, CopyOf(node.arguments)};
}
UnaryExpression CopyOf(const UnaryExpression& node) { return {node.op, CopyOf(node.operand)}; }
BinaryExpression CopyOf(const BinaryExpression& node) {
  return {node.op, node.op_span, CopyOf(node.left), CopyOf(node.right),
          node.tolerance != nullptr ? CopyOf(node.tolerance) : nullptr};
}

}  // namespace

Expression CopyOf(const Expression& expression) {
  Expression copy{expression.span, {}};
  std::visit([&](const auto& node) { copy.node = CopyOf(node); }, expression.node);
  return copy;
}

}  // namespace compiler
