#include "compiler/check/named_constants.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/check/constant_value.h"
#include "compiler/check/conversion.h"
#include "compiler/check/declared_type.h"
#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/open_set.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/check/written_names.h"

namespace compiler {
namespace {

constexpr Place kConstantPlace{Place::kConstant};

using Written = std::variant<const ConstDeclaration*, const SetDeclaration*>;

struct Entry {
  Written written;
  enum { kUnseen, kOpen, kDone } state = kUnseen;
};

const Identifier& NameOf(const Entry& entry) {
  return std::visit([](const auto* node) -> const Identifier& { return node->name; },
                    entry.written);
}
// The names to which it refers.
std::vector<const Identifier*> NamesIn(const ConstDeclaration& constant) {
  std::vector<const Identifier*> names;
  CollectNames(constant.value, names);
  return names;
}
std::vector<const Identifier*> NamesIn(const SetDeclaration& set) {
  std::vector<const Identifier*> names;
  for (const ExpressionPtr& item : set.items) CollectNames(*item, names);
  return names;
}

std::vector<Entry> EntriesOf(const SyntaxTree& tree) {
  std::vector<Entry> entries;
  for (const Declaration& declaration : tree.declarations) {
    if (const auto* constant = std::get_if<ConstDeclaration>(&declaration.node))
      entries.push_back({constant});
    if (const auto* set = std::get_if<SetDeclaration>(&declaration.node)) entries.push_back({set});
  }
  return entries;
}

// The first names of what is declared and has no value before the run.
std::set<std::string, std::less<>> VariablesOf(const SyntaxTree& tree) {
  std::set<std::string, std::less<>> names;
  for (const Declaration& declaration : tree.declarations) {
    if (const auto* param = std::get_if<ParamDeclaration>(&declaration.node))
      names.insert(param->name.text);
    if (const auto* memory = std::get_if<MemoryDeclaration>(&declaration.node))
      names.insert(memory->name.text);
    if (const auto* goal = std::get_if<GoalDeclaration>(&declaration.node))
      names.insert(goal->name.text);
    if (const auto* sensor = std::get_if<SensorDeclaration>(&declaration.node))
      names.insert(sensor->name.text.substr(0, sensor->name.text.find('.')));
  }
  return names;
}

// Checks each declaration after those that it refers to: a depth-first search.
class ConstantsCheck {
 public:
  ConstantsCheck(const SyntaxTree& tree, TaskScope& scope)
      : entries_(EntriesOf(tree)), variables_(VariablesOf(tree)), scope_(scope) {
    for (size_t i = 0; i < entries_.size(); ++i) by_name_.try_emplace(NameOf(entries_[i]).text, i);
  }

  void Run() {
    for (size_t i = 0; i < entries_.size(); ++i) Visit(i);
  }

 private:
  void Visit(size_t index) {
    Entry& entry = entries_[index];
    if (entry.state != Entry::kUnseen) return;
    entry.state = Entry::kOpen;
    way_.push_back(index);
    std::visit([&](const auto* node) { Follow(NamesIn(*node)); }, entry.written);
    way_.pop_back();
    entry.state = Entry::kDone;
    const Identifier& name = NameOf(entry);
    Symbol symbol = std::visit([&](const auto* node) { return Check(*node); }, entry.written);
    if (in_circle_.contains(index)) symbol.is_valid = false;
    scope_.constants.names.push_back(name);
    if (IsPartOfRobot(name, WhatIs(symbol.kind), scope_)) {
      scope_.refused.insert(name.text);
    } else {
      DeclareSymbol(name, symbol, scope_);
    }
  }

  void Follow(const std::vector<const Identifier*>& names) {
    for (const Identifier* name : names) {
      const auto found = by_name_.find(name->text);
      if (found == by_name_.end() && variables_.contains(name->text)) ReportVariable(*name);
      if (found == by_name_.end()) continue;
      if (entries_[found->second].state == Entry::kOpen) {
        ReportCircle(found->second, *name);
      } else {
        Visit(found->second);
      }
    }
  }

  void ReportVariable(const Identifier& name) {
    scope_.refused.insert(name.text);
    Report(
        scope_.diagnostics, code::kNotConstant, name.span,
        fmt::format("`{}` is not known before the task runs", name.text),
        {.help = "consts and sets are made of numbers, of names of the robot, and of each other"});
  }

  // The end of the way refers to `first`, which the way came through.
  void ReportCircle(size_t first, const Identifier& use) {
    const auto begin = std::ranges::find(way_, first);
    std::vector<std::string> others;
    for (auto step = begin; step != way_.end(); ++step) {
      in_circle_.insert(*step);
      if (step != begin) others.push_back(NameOf(entries_[*step]).text);
    }
    const Identifier& name = NameOf(entries_[first]);
    if (!circles_.insert(first).second) return;
    // Its uses would only be reported as unknown.
    scope_.refused.insert(name.text);
    Report(scope_.diagnostics, code::kConstCircle, name.span,
           fmt::format("`{}` depends on itself{}", name.text,
                       others.empty() ? "" : fmt::format(" through {}", List(others))),
           {.help = others.empty() ? "write its value without it"
                                   : "give at least one of them a value without the others",
            .labels = {{use.span, fmt::format("`{}` is used here", name.text)}}});
  }

  // ---- Consts ----

  Symbol Check(const ConstDeclaration& constant) {
    Symbol symbol{.kind = SymbolKind::kConst, .is_valid = false};
    const auto declared = CheckDeclaredType(constant.type, constant.unit, scope_);
    auto value = CheckExpression(constant.value, kConstantPlace, scope_);
    if (!declared || !value) return symbol;
    auto elements = ElementsOf(constant, *declared, std::move(*value));
    if (!elements) return symbol;
    symbol = {.kind = SymbolKind::kConst,
              .index = static_cast<uint32_t>(scope_.constants.consts.size()),
              .type = declared->type,
              .unit = declared->unit};
    scope_.constants.consts.push_back(
        {constant.name.text, declared->type, declared->unit, std::move(*elements)});
    return symbol;
  }

  // One scalar is the value of every element.
  std::optional<Reals> ElementsOf(const ConstDeclaration& constant, const DeclaredType& declared,
                                  CheckedExpression value) {
    const bool is_scalar = IsScalar(value.type);
    const Type wanted = is_scalar ? ScalarType(declared.type.scalar) : declared.type;
    auto fitting = ConvertTo({std::move(value), &constant.value}, wanted, declared.unit,
                             fmt::format("`{}`", constant.name.text), scope_.diagnostics);
    if (!fitting) return std::nullopt;
    Reals elements = ToReals(*ConstantValueOf(*fitting, scope_.constants.consts));
    if (!std::ranges::all_of(elements, [](double element) { return std::isfinite(element); })) {
      Report(scope_.diagnostics, code::kNotFinite, constant.value.span,
             "the value of this is not a finite number");
      return std::nullopt;
    }
    if (is_scalar) elements.resize(declared.type.size(), elements.front());
    return elements;
  }

  // ---- Sets ----

  Symbol Check(const SetDeclaration& set) {
    Symbol symbol{.kind = SymbolKind::kSet, .is_valid = false};
    auto resolved = ResolveOpenSet(set.items, set.items_span, IndexUse::kSet, scope_);
    if (!resolved) return symbol;
    CheckedSet checked{.name = set.name.text, .parts = {}, .indices = {}, .names = {}};
    if (resolved->parts != nullptr) checked.parts = resolved->parts->name;
    for (const uint32_t index : resolved->indices)
      checked.names.push_back(MemberText(index, resolved->parts));
    checked.indices = std::move(resolved->indices);
    symbol.is_valid = true;
    symbol.index = static_cast<uint32_t>(scope_.constants.sets.size());
    symbol.type.index = checked.parts;
    scope_.constants.sets.push_back(std::move(checked));
    return symbol;
  }

  std::vector<Entry> entries_;
  std::set<std::string, std::less<>> variables_;
  TaskScope& scope_;
  std::map<std::string, size_t, std::less<>> by_name_;  // of two of one name, the first
  std::vector<size_t> way_;
  std::set<size_t> in_circle_;
  std::set<size_t> circles_;  // by the declaration of which they have been reported
};

}  // namespace

void CheckConstants(const SyntaxTree& tree, TaskScope& scope) { ConstantsCheck(tree, scope).Run(); }

void WarnOfUnusedConstants(const SyntaxTree& tree, const NamedConstants& constants,
                           Diagnostics& diagnostics) {
  for (const Declaration& declaration : tree.declarations) {
    const auto* constant = std::get_if<ConstDeclaration>(&declaration.node);
    const auto* set = std::get_if<SetDeclaration>(&declaration.node);
    const auto* table = std::get_if<TableDeclaration>(&declaration.node);
    if (declaration.is_imported) continue;
    if (constant != nullptr && !constants.used.contains(constant->name.text))
      Report(diagnostics, code::kUnusedConst, constant->name.span,
             fmt::format("the const `{}` is never used", constant->name.text));
    if (set != nullptr && !constants.used.contains(set->name.text))
      Report(diagnostics, code::kUnusedSet, set->name.span,
             fmt::format("the set `{}` is never used", set->name.text));
    if (table != nullptr && !constants.used.contains(table->name.text))
      Report(diagnostics, code::kUnusedTable, table->name.span,
             fmt::format("the table `{}` is never used", table->name.text));
  }
}

}  // namespace compiler
