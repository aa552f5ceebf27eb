#include "compiler/check/written_names.h"

namespace compiler {

void CollectNames(const Expression& expression, std::vector<const Identifier*>& names) {
  const auto collect = [&](const ExpressionPtr& part) { CollectNames(*part, names); };
  const auto collect_all = [&](const std::vector<ExpressionPtr>& parts) {
    for (const ExpressionPtr& part : parts) collect(part);
  };
  std::visit(
      [&]<typename Node>(const Node& node) {
        if constexpr (std::is_same_v<Node, NameExpression>) names.push_back(&node.name);
        if constexpr (requires { node.object; }) collect(node.object);
        if constexpr (requires { node.items; }) collect_all(node.items);
        if constexpr (requires { node.arguments; }) collect_all(node.arguments);
        if constexpr (requires { node.operand; }) collect(node.operand);
        if constexpr (requires { node.first; }) {
          collect(node.first);
          collect(node.last);
        }
        if constexpr (requires { node.left; }) {
          collect(node.left);
          collect(node.right);
          if (node.tolerance != nullptr) collect(node.tolerance);
        }
      },
      expression.node);
}

}  // namespace compiler
