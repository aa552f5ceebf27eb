#include "compiler/check/tables.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/constant_value.h"
#include "compiler/check/conversion.h"
#include "compiler/check/declared_type.h"
#include "compiler/check/expressions.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/table_columns.h"
#include "compiler/check/table_elements.h"
#include "compiler/check/table_value.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

bool CanBeInterpolated(const TableDeclaration& table, const Type& type, const TaskScope& scope) {
  const bool is_matrix = type.shape == Shape::kMatrix;
  if (type.scalar == Scalar::kReal && !is_matrix) return true;
  Report(scope.diagnostics, code::kBadTableType, table.type.span,
         fmt::format("there are no tables of `{}`", ToString(type)),
         {.help = is_matrix ? "rotations are interpolated as `quat`, other numbers as `real[N]`"
                            : "between two rows there are only numbers: declare it as `real`"});
  return false;
}

// A table whose type and file are good.
struct Readable {
  const TableDeclaration* table = nullptr;
  DeclaredType declared;
};
// What is read from one file.
struct FileUse {
  std::vector<Readable> tables;
  bool is_known = true;  // all that is read from it
};
using FileUses = std::map<uint32_t, FileUse>;  // by where the text of the file begins

FileUses UsesOf(const SyntaxTree& tree, const TaskScope& scope) {
  FileUses uses;
  for (const Declaration& declaration : tree.declarations) {
    const auto* table = std::get_if<TableDeclaration>(&declaration.node);
    if (table == nullptr) continue;
    const auto declared = CheckDeclaredType(table->type, table->unit, scope);
    const bool is_good = declared && CanBeInterpolated(*table, declared->type, scope);
    if (!table->source.file) continue;
    FileUse& use = uses[table->source.file->columns.front().span.begin];
    if (is_good) {
      use.tables.push_back({table, *declared});
    } else {
      use.is_known = false;
    }
  }
  return uses;
}

void ReadFile(const FileUse& use, std::map<std::string, Symbol>& symbols, TaskScope& scope) {
  std::vector<std::string> wanted;
  for (const Readable& each : use.tables)
    std::ranges::move(ColumnNames(*each.table, each.declared.type, scope),
                      std::back_inserter(wanted));
  std::vector<std::string> misspelled;
  if (use.is_known) misspelled = CheckColumns(*use.tables.front().table, wanted, scope);
  for (const auto& [table, declared] : use.tables) {
    auto checked = ResolveElements(*table, declared, misspelled, scope);
    if (!checked) continue;
    symbols[table->name.text] = {.kind = SymbolKind::kTable,
                                 .index = static_cast<uint32_t>(scope.constants.tables.size()),
                                 .type = declared.type,
                                 .unit = declared.unit};
    scope.constants.tables.push_back(std::move(*checked));
  }
}

// The elements of a constant, listed.
CheckedExpression ListOf(const Reals& elements, CheckedExpression read) {
  if (IsScalar(read.type)) {
    read.node = Constant{elements.front()};
    return read;
  }
  BuiltinCall list{Builtin::kVector, {}};
  for (const double element : elements)
    list.arguments.push_back(std::make_unique<CheckedExpression>(
        CheckedExpression{read.span, kRealType, read.unit, Constant{element}}));
  read.node = std::move(list);
  return read;
}

// The second argument, which can only be `loop`.
std::optional<bool> Repeats(const CallExpression& call, const TaskScope& scope) {
  if (call.arguments.size() == 1) return false;
  const Expression& way = *call.arguments[1];
  const auto* word = std::get_if<NameExpression>(&way.node);
  if (word != nullptr && word->name.text == kLoopWord) return true;
  Report(scope.diagnostics, code::kBadTableCall, way.span,
         "the second argument of a table can only be `loop`",
         {.help = {fmt::format("write `{}(x, loop)`: after the last row comes the first again",
                               call.function.text),
                   {{way.span, std::string(kLoopWord)}}}});
  return std::nullopt;
}

// "its argument `time` is in `s`"
std::string ArgumentText(const CheckedTable& table) {
  const Unit& unit = table.argument_unit;
  return fmt::format("its argument `{}` is {}{}", table.argument, IsPlain(unit) ? "" : "in ",
                     NameOf(unit));
}

bool HasArguments(const CallExpression& call, Span span, const TaskScope& scope) {
  if (call.arguments.size() == 1 || call.arguments.size() == 2) return true;
  Report(
      scope.diagnostics, code::kBadTableCall, span,
      fmt::format("`{}` is read with one argument", call.function.text),
      {.help = fmt::format("write `{0}(x)`, or `{0}(x, loop)` to repeat it", call.function.text)});
  return false;
}

}  // namespace

// With errors in its type or file, nothing is in a table.
void CheckTables(const SyntaxTree& tree, TaskScope& scope) {
  std::map<std::string, Symbol> symbols;
  for (const auto& [place, use] : UsesOf(tree, scope))
    if (!use.tables.empty()) ReadFile(use, symbols, scope);
  for (const Declaration& declaration : tree.declarations) {
    const auto* table = std::get_if<TableDeclaration>(&declaration.node);
    if (table == nullptr) continue;
    scope.constants.names.push_back(table->name);
    const auto found = symbols.find(table->name.text);
    DeclareSymbol(table->name,
                  found != symbols.end() ? found->second
                                         : Symbol{.kind = SymbolKind::kTable, .is_valid = false},
                  scope);
  }
}

const Symbol* FindTable(const CallExpression& call, const TaskScope& scope) {
  const Symbol* symbol = scope.symbols.Find(call.function.text);
  if (symbol == nullptr || symbol->kind != SymbolKind::kTable) return nullptr;
  return FindSymbol(call.function, scope);
}

std::optional<CheckedExpression> CheckTableCall(const CallExpression& call, const Symbol& table,
                                                Span span, const Place& place,
                                                const TaskScope& scope) {
  if (!HasArguments(call, span, scope)) return std::nullopt;
  auto argument = CheckExpression(*call.arguments[0], place, scope);
  const auto repeats = Repeats(call, scope);
  if (!argument || !repeats || !table.is_valid) return std::nullopt;
  const CheckedTable& checked = scope.constants.tables[table.index];
  argument = ConvertTo({std::move(*argument), call.arguments[0].get()}, kRealType,
                       checked.argument_unit, fmt::format("the argument of `{}`", checked.name),
                       scope.diagnostics, {{table.span, ArgumentText(checked)}});
  if (!argument) return std::nullopt;
  CheckedExpression read{span, table.type, table.unit, Constant{}};
  if (const auto value = ConstantValueOf(*argument, scope.constants.consts))
    return ListOf(ValueAt(checked, RealOf(*value), *repeats), std::move(read));
  read.node =
      TableRead{table.index, *repeats, std::make_unique<CheckedExpression>(std::move(*argument))};
  return read;
}

std::optional<CheckedExpression> CheckDuration(const CallExpression& call, Span span,
                                               const TaskScope& scope) {
  const auto* name =
      call.arguments.size() == 1 ? std::get_if<NameExpression>(&call.arguments[0]->node) : nullptr;
  const Symbol* table = name != nullptr ? FindSymbol(name->name, scope) : nullptr;
  if (table == nullptr || table->kind != SymbolKind::kTable) {
    const bool is_lost = name != nullptr && table == nullptr &&
                         (!scope.knows_names || scope.refused.contains(name->name.text));
    if (!is_lost)
      Report(scope.diagnostics, code::kBadTableCall, span, "`duration` takes the name of a table",
             {.help = "write `duration(NAME)`: from the first row's argument to the last's"});
    return std::nullopt;
  }
  if (!table->is_valid) return std::nullopt;
  const CheckedTable& checked = scope.constants.tables[table->index];
  return CheckedExpression{span, kRealType, checked.argument_unit, Constant{checked.duration()}};
}

}  // namespace compiler
