#include "compiler/check/after_end.h"

#include <optional>

#include "compiler/check/hidden_memory.h"
#include "compiler/check/traversal.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

AfterEnd AfterEndOf(const SyntaxTree& tree) {
  for (const Declaration& declaration : tree.declarations)
    if (const auto* after = std::get_if<AfterEndDeclaration>(&declaration.node))
      return after->behavior;
  return AfterEnd::kStop;
}

bool Ends(const CheckedStatement& statement) {
  return std::holds_alternative<CheckedEnd>(statement.node) ||
         std::holds_alternative<CheckedRequire>(statement.node);
}

// The first statement that can end an episode before it is over.
std::optional<Span> FirstEnd(const CheckedTask& task) {
  std::optional<Span> first;
  for (size_t i = 0; i < task.events.size(); ++i) {
    if (static_cast<EventKind>(i) == EventKind::kEndOfEpisode) continue;
    ForEachStatement(task.events[i].body, [&](const CheckedStatement& statement) {
      if (!first && Ends(statement)) first = statement.span;
    });
  }
  return first;
}

}  // namespace

void AddMemoryOfEnd(const SyntaxTree& tree, CheckedTask& task) {
  const std::optional<Span> first = FirstEnd(task);
  if (!first || AfterEndOf(tree) == AfterEnd::kContinue) return;
  task.ended = AddHiddenMemory("ended#", ScalarType(Scalar::kBool), {}, MemoryScope::kPerEpisode,
                               *first, task);
}

bool CanEnd(const CheckedBlock& block) {
  bool can_end = false;
  ForEachStatement(block, [&](const CheckedStatement& statement) { can_end |= Ends(statement); });
  return can_end;
}

}  // namespace compiler
