#include "compiler/check/open_set.h"

#include <string>

#include "compiler/check/report.h"
#include "compiler/check/written_names.h"

namespace compiler {
namespace {

// What a set consists of, by its names.
struct SetKind {
  const Enumeration* parts = nullptr;   // null: numbers
  const Identifier* unknown = nullptr;  // a name without any meaning
};

// "link" where the symbol stands for some of them.
std::string_view PartsOf(const Symbol* symbol) {
  const bool has_parts = symbol != nullptr && (symbol->kind == SymbolKind::kLoopPart ||
                                               symbol->kind == SymbolKind::kSet);
  return has_parts ? std::string_view(symbol->type.index) : "";
}

SetKind KindOf(const std::vector<ExpressionPtr>& items, const TaskScope& scope) {
  std::vector<const Identifier*> names;
  for (const ExpressionPtr& item : items) CollectNames(*item, names);
  SetKind kind;
  for (const Identifier* name : names) {
    const Symbol* symbol = scope.symbols.Find(name->text);
    const Enumeration* parts = FindEnumerationOf(scope.enumerations, name->text);
    if (const std::string_view known = PartsOf(symbol); !known.empty())
      parts = FindEnumeration(scope.enumerations, known);
    if (parts != nullptr) return {parts, nullptr};
    if (symbol == nullptr && kind.unknown == nullptr) kind.unknown = name;
  }
  return kind;
}

void ReportUnknownSet(const Identifier& name, IndexUse use, const TaskScope& scope) {
  if (!scope.knows_robot || !scope.knows_names || scope.refused.contains(name.text)) return;
  if (!scope.has_robot) {
    const bool is_loop = use == IndexUse::kLoop;
    Report(scope.diagnostics, code::kUnknownPart, name.span,
           fmt::format("there is no `{}`{}", name.text, is_loop ? " to iterate over" : ""),
           {.note = "only a robot has links, joints and sites",
            .help = fmt::format("{} numbers, as in `0..3`", is_loop ? "iterate over" : "write")});
    return;
  }
  std::vector<std::string> valid;
  std::string one, all, choices;  // "link, joint", "links, joints", "`links`, `joints`"
  for (const Enumeration& parts : scope.enumerations) {
    for (std::string& part : parts.Names()) valid.push_back(std::move(part));
    one += (one.empty() ? "" : ", ") + parts.name;
    all += (all.empty() ? "" : ", ") + parts.all;
    choices += fmt::format("{}`{}`", choices.empty() ? "" : ", ", parts.all);
  }
  for (const Identifier& constant : scope.constants.names) valid.push_back(constant.text);
  Help help = Suggest(name.span, name.text, valid, all + " and groups");
  if (help.empty())
    help = fmt::format("{} {}, some of them, or numbers as in `0..3`",
                       use == IndexUse::kLoop ? "iterate over" : "write", choices);
  Report(scope.diagnostics, code::kUnknownPart, name.span,
         fmt::format("the robot has no {} or group called `{}`", one, name.text),
         {.help = std::move(help)});
}

}  // namespace

std::optional<OpenSet> ResolveOpenSet(const std::vector<ExpressionPtr>& items, Span span,
                                      IndexUse use, const TaskScope& scope) {
  const SetKind kind = KindOf(items, scope);
  if (kind.parts == nullptr && kind.unknown != nullptr) {
    ReportUnknownSet(*kind.unknown, use, scope);
    return std::nullopt;
  }
  const uint32_t size = kind.parts != nullptr ? kind.parts->size() : kNumbersOfOpenSet;
  auto indices =
      ResolveIndexSet(items, span, {.size = size, .names = kind.parts, .use = use}, scope);
  if (!indices) return std::nullopt;
  return OpenSet{kind.parts, std::move(*indices)};
}

std::string MemberText(uint32_t index, const Enumeration* parts) {
  return parts == nullptr ? std::to_string(index) : parts->members[index];
}

bool IsPartOfRobot(const Identifier& name, std::string_view what, const TaskScope& scope) {
  const Enumeration* parts = FindEnumerationOf(scope.enumerations, name.text);
  if (parts == nullptr) return false;
  Report(scope.diagnostics, code::kTakenName, name.span,
         fmt::format("`{}` is a name among the {} of the robot and cannot be {}", name.text,
                     parts->all, what),
         {.help = "choose another name"});
  return true;
}

}  // namespace compiler
