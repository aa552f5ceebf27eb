#include "compiler/check/loop.h"

#include <utility>

#include "compiler/check/names.h"
#include "compiler/check/open_set.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

LoopValue ValueOf(uint32_t index, const Enumeration* parts, Span variable) {
  Symbol symbol{.kind = SymbolKind::kLoopNumber,
                .span = variable,
                .index = index,
                .type = ScalarType(Scalar::kInt)};
  if (parts != nullptr) {
    symbol.kind = SymbolKind::kLoopPart;
    symbol.type.index = parts->name;
  }
  return {MemberText(index, parts), symbol};
}

}  // namespace

std::optional<std::vector<LoopValue>> ResolveLoop(const ForStatement& loop,
                                                  const TaskScope& scope) {
  const auto set = ResolveOpenSet(loop.items, loop.items_span, IndexUse::kLoop, scope);
  if (!set) return std::nullopt;
  std::vector<LoopValue> values;
  for (const uint32_t index : set->indices)
    values.push_back(ValueOf(index, set->parts, loop.variable.span));
  return values;
}

Symbol UnknownLoopVariable() { return {.kind = SymbolKind::kLoopNumber, .is_valid = false}; }

bool CheckLoopVariable(const Identifier& variable, TaskScope& scope) {
  if (IsPartOfRobot(variable, "a loop's variable", scope)) return false;
  scope.symbols.OpenBlock();
  const bool is_free = DeclareSymbol(variable, UnknownLoopVariable(), scope);
  scope.symbols.CloseBlock();
  return is_free;
}

}  // namespace compiler
