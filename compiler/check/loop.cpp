#include "compiler/check/loop.h"

#include <utility>

#include "compiler/check/index_set.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// The names in an index set, from left to right.
void CollectNames(const Expression& item, std::vector<const Identifier*>& names) {
  const auto collect = [&](const ExpressionPtr& part) { CollectNames(*part, names); };
  std::visit(
      [&]<typename Node>(const Node& node) {
        if constexpr (std::is_same_v<Node, NameExpression>) {
          names.push_back(&node.name);
        } else if constexpr (std::is_same_v<Node, RangeExpression>) {
          collect(node.first);
          collect(node.last);
        } else if constexpr (std::is_same_v<Node, SetExpression>) {
          for (const ExpressionPtr& part : node.items) collect(part);
        } else if constexpr (std::is_same_v<Node, BinaryExpression>) {
          collect(node.left);
          collect(node.right);
        }
      },
      item.node);
}

// What a loop goes through, by its names.
struct LoopKind {
  const Enumeration* parts = nullptr;   // null: numbers
  const Identifier* unknown = nullptr;  // a name without any meaning
};

LoopKind KindOf(const ForStatement& loop, const TaskScope& scope) {
  std::vector<const Identifier*> names;
  for (const ExpressionPtr& item : loop.items) CollectNames(*item, names);
  LoopKind kind;
  for (const Identifier* name : names) {
    const Symbol* symbol = scope.symbols.Find(name->text);
    const Enumeration* parts = FindEnumerationOf(scope.enumerations, name->text);
    if (symbol != nullptr && symbol->kind == SymbolKind::kLoopPart)
      parts = FindEnumeration(scope.enumerations, symbol->type.index);
    if (parts != nullptr) return {parts, nullptr};
    if (symbol == nullptr && kind.unknown == nullptr) kind.unknown = name;
  }
  return kind;
}

void ReportUnknownSet(const Identifier& name, const TaskScope& scope) {
  if (!scope.knows_robot || !scope.knows_names || scope.refused.contains(name.text)) return;
  if (!scope.has_robot) {
    Report(scope.diagnostics, code::kUnknownPart, name.span,
           fmt::format("there is no `{}` to iterate over", name.text),
           {.note = "only a robot has links and joints",
            .help = "iterate over numbers, as in `0..3`"});
    return;
  }
  std::vector<std::string> valid;
  for (const Enumeration& parts : scope.enumerations)
    for (std::string& part : parts.Names()) valid.push_back(std::move(part));
  Help help = Suggest(name.span, name.text, valid, "links, joints and groups");
  if (help.empty()) help = "iterate over `links`, `joints`, some of them, or numbers as in `0..3`";
  Report(scope.diagnostics, code::kUnknownPart, name.span,
         fmt::format("the robot has no link, joint or group called `{}`", name.text),
         {.help = std::move(help)});
}

LoopValue ValueOf(uint32_t index, const Enumeration* parts, Span variable) {
  Symbol symbol{.kind = SymbolKind::kLoopNumber,
                .span = variable,
                .index = index,
                .type = ScalarType(Scalar::kInt)};
  if (parts == nullptr) return {std::to_string(index), symbol};
  symbol.kind = SymbolKind::kLoopPart;
  symbol.type.index = parts->name;
  return {parts->members[index], symbol};
}

}  // namespace

std::optional<std::vector<LoopValue>> ResolveLoop(const ForStatement& loop,
                                                  const TaskScope& scope) {
  const LoopKind kind = KindOf(loop, scope);
  if (kind.parts == nullptr && kind.unknown != nullptr) {
    ReportUnknownSet(*kind.unknown, scope);
    return std::nullopt;
  }
  const uint32_t size = kind.parts != nullptr ? kind.parts->size() : kMostStatements;
  const auto indices = ResolveIndexSet(loop.items, loop.items_span,
                                       {.size = size, .names = kind.parts, .is_loop = true}, scope);
  if (!indices) return std::nullopt;
  std::vector<LoopValue> values;
  for (const uint32_t index : *indices)
    values.push_back(ValueOf(index, kind.parts, loop.variable.span));
  return values;
}

Symbol UnknownLoopVariable() { return {.kind = SymbolKind::kLoopNumber, .is_valid = false}; }

bool CheckLoopVariable(const Identifier& variable, TaskScope& scope) {
  if (const Enumeration* parts = FindEnumerationOf(scope.enumerations, variable.text)) {
    Report(scope.diagnostics, code::kTakenName, variable.span,
           fmt::format("`{}` is a name among the {} of the robot and cannot be a loop's variable",
                       variable.text, parts->all),
           {.help = "choose another name"});
    return false;
  }
  scope.symbols.OpenBlock();
  const bool is_free = DeclareSymbol(variable, UnknownLoopVariable(), scope);
  scope.symbols.CloseBlock();
  return is_free;
}

}  // namespace compiler
