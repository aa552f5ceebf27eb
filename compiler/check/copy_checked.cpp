#include "compiler/check/copy_checked.h"

#include <algorithm>
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
FunctionCall CopyOf(const FunctionCall& node) {
  return {node.function, CopyOf(node.arguments), node.is_each};
}
Draw CopyOf(const Draw& node) { return {node.distribution, node.site, CopyOf(node.arguments)}; }
TableRead CopyOf(const TableRead& node) { return {node.table, node.repeats, CopyOf(node.operand)}; }
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

namespace {

bool IsSamePart(const CheckedExpressionPtr& a, const CheckedExpressionPtr& b) {
  return IsSame(*a, *b);
}
bool IsSamePart(const std::vector<CheckedExpressionPtr>& a,
                const std::vector<CheckedExpressionPtr>& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return IsSame(*x, *y); });
}

bool IsSameNode(const Constant& a, const Constant& b) { return a.value == b.value; }
bool IsSameNode(const ConstRead& a, const ConstRead& b) { return a.index == b.index; }
bool IsSameNode(const SensorRead& a, const SensorRead& b) { return a.sensor == b.sensor; }
bool IsSameNode(const ParamRead& a, const ParamRead& b) { return a.param == b.param; }
bool IsSameNode(const MemoryRead& a, const MemoryRead& b) { return a.memory == b.memory; }
bool IsSameNode(const LocalRead& a, const LocalRead& b) { return a.local == b.local; }
bool IsSameNode(const ArgumentRead& a, const ArgumentRead& b) { return a.argument == b.argument; }
bool IsSameNode(const RewardSoFar&, const RewardSoFar&) { return true; }
bool IsSameNode(const TimeStep&, const TimeStep&) { return true; }
bool IsSameNode(const Elements& a, const Elements& b) {
  return a.indices == b.indices && IsSamePart(a.operand, b.operand);
}
bool IsSameNode(const CheckedUnary& a, const CheckedUnary& b) {
  return a.op == b.op && IsSamePart(a.operand, b.operand);
}
bool IsSameNode(const CheckedBinary& a, const CheckedBinary& b) {
  return a.op == b.op && IsSamePart(a.left, b.left) && IsSamePart(a.right, b.right);
}
bool IsSameNode(const CheckedWithin& a, const CheckedWithin& b) {
  return a.is_equal == b.is_equal && IsSamePart(a.left, b.left) && IsSamePart(a.right, b.right) &&
         IsSamePart(a.tolerance, b.tolerance);
}
bool IsSameNode(const BuiltinCall& a, const BuiltinCall& b) {
  return a.function == b.function && IsSamePart(a.arguments, b.arguments);
}
bool IsSameNode(const FunctionCall& a, const FunctionCall& b) {
  return a.function == b.function && IsSamePart(a.arguments, b.arguments);
}
bool IsSameNode(const Draw& a, const Draw& b) { return a.site == b.site; }
bool IsSameNode(const TableRead& a, const TableRead& b) {
  return a.table == b.table && a.repeats == b.repeats && IsSamePart(a.operand, b.operand);
}
bool IsSameNode(const TestRead& a, const TestRead& b) {
  return a.kind == b.kind && a.index == b.index;
}
bool IsSameNode(const IntToReal& a, const IntToReal& b) { return IsSamePart(a.operand, b.operand); }

}  // namespace

bool IsSame(const CheckedExpression& a, const CheckedExpression& b) {
  if (!(a.type == b.type) || !(a.unit == b.unit) || a.node.index() != b.node.index()) return false;
  return std::visit(
      [&]<typename Node>(const Node& node) { return IsSameNode(node, std::get<Node>(b.node)); },
      a.node);
}

size_t SizeOf(const CheckedExpression& expression) {
  size_t size = 0;
  ForEachPart(expression, [&](const CheckedExpression&) { ++size; });
  return size;
}

}  // namespace compiler
