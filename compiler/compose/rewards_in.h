// The statements of a task that pay.
#pragma once

#include <variant>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

template <typename Visitor>
void ForEachReward(Block& block, const Visitor& visit);

template <typename Visitor>
void ForEachReward(Statement& statement, const Visitor& visit) {
  if (std::holds_alternative<RewardStatement>(statement.node)) visit(statement);
  if (auto* loop = std::get_if<ForStatement>(&statement.node)) ForEachReward(loop->body, visit);
  if (auto* once = std::get_if<OnceStatement>(&statement.node))
    for (IfBranch& branch : once->branches) ForEachReward(branch.body, visit);
  if (auto* branches = std::get_if<IfStatement>(&statement.node)) {
    for (IfBranch& branch : branches->branches) ForEachReward(branch.body, visit);
    if (branches->otherwise) ForEachReward(*branches->otherwise, visit);
  }
}

template <typename Visitor>
void ForEachReward(Block& block, const Visitor& visit) {
  for (Statement& statement : block) ForEachReward(statement, visit);
}

// Calls `visit` with each statement that pays, also with those that other files have appended.
template <typename Visitor>
void ForEachReward(SyntaxTree& tree, const Visitor& visit) {
  for (Declaration& declaration : tree.declarations) {
    if (auto* phase = std::get_if<PhaseDeclaration>(&declaration.node))
      ForEachReward(phase->body, visit);
    auto* event = std::get_if<EventDeclaration>(&declaration.node);
    if (event == nullptr) continue;
    ForEachReward(event->body, visit);
    for (Block& block : event->appended) ForEachReward(block, visit);
  }
}

}  // namespace compiler
