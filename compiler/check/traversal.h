// Walks over checked tasks, for passes that look at every expression or statement.
#pragma once

#include <type_traits>
#include <variant>

#include "compiler/check/checked_task.h"

namespace compiler {

// Calls `visit`, from left to right, for what the expression is computed from, and not for their
// parts. With a constant expression `visit` gets constant ones.
template <typename ExpressionType, typename Visit>
requires std::is_same_v<std::remove_const_t<ExpressionType>, CheckedExpression>
void ForEachDirectPart(ExpressionType& expression, const Visit& visit) {
  // A pointer does not pass its own constness on to what it points to; this does.
  const auto part = [&](const CheckedExpressionPtr& pointer) {
    visit(static_cast<ExpressionType&>(*pointer));
  };
  std::visit(
      [&]<typename Node>(const Node& node) {
        if constexpr (requires { node.operand; }) {
          part(node.operand);
        } else if constexpr (requires { node.left; }) {
          part(node.left);
          part(node.right);
          if constexpr (requires { node.tolerance; }) part(node.tolerance);
        } else if constexpr (requires { node.arguments; }) {
          for (const CheckedExpressionPtr& argument : node.arguments) part(argument);
        }
      },
      expression.node);
}

// Calls `visit` for the expression and, from left to right, for all of its parts.
template <typename ExpressionType, typename Visit>
requires std::is_same_v<std::remove_const_t<ExpressionType>, CheckedExpression>
void ForEachPart(ExpressionType& expression, const Visit& visit) {
  visit(expression);
  ForEachDirectPart(expression, [&](ExpressionType& part) { ForEachPart(part, visit); });
}

// Calls `visit` for every statement of the block, and of the blocks inside it, in their order.
template <typename BlockType, typename Visit>
requires std::is_same_v<std::remove_const_t<BlockType>, CheckedBlock>
void ForEachStatement(BlockType& block, const Visit& visit) {
  for (auto& statement : block) {
    visit(statement);
    if (auto* branches = std::get_if<CheckedIf>(&statement.node)) {
      for (auto& branch : branches->branches) ForEachStatement(branch.body, visit);
      ForEachStatement(branches->otherwise, visit);
    }
    if (auto* loop = std::get_if<CheckedFor>(&statement.node))
      for (auto& pass : loop->passes) ForEachStatement(pass.body, visit);
    if (auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node))
      for (auto& inner : phases->blocks) ForEachStatement(inner, visit);
  }
}

// Calls `visit` for every whole expression of a statement, without the statements inside it.
template <typename StatementType, typename Visit>
requires std::is_same_v<std::remove_const_t<StatementType>, CheckedStatement>
void ForEachExpression(StatementType& statement, const Visit& visit) {
  std::visit(
      [&](auto& node) {
        if constexpr (requires { node.duration; }) {
          visit(node.value);
          if (node.duration) visit(*node.duration);
        } else if constexpr (requires { node.value; }) {
          visit(node.value);
        } else if constexpr (requires { node.branches; }) {
          for (auto& branch : node.branches) visit(branch.condition);
        } else if constexpr (requires { node.condition; }) {
          visit(node.condition);
        }
      },
      statement.node);
}

}  // namespace compiler
