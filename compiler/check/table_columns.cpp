#include "compiler/check/table_columns.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/table_messages.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

std::vector<std::string> LettersIn(const Type& type, Shape shape) {
  if (shape == Shape::kQuaternion) return {"w", "x", "y", "z"};
  const uint32_t size = type.shape == Shape::kArray ? type.columns : type.rows;
  const std::vector<std::string> letters = {"x", "y", "z", "w"};
  return {letters.begin(), letters.begin() + size};
}

std::vector<std::string> NamesInArray(const Type& type, const TaskScope& scope) {
  const Enumeration* parts = FindEnumeration(scope.enumerations, type.index);
  std::vector<std::string> names;
  for (uint32_t i = 0; i < type.rows; ++i) {
    const std::string entry = parts != nullptr ? parts->members[i] : std::to_string(i);
    if (!HasVectors(type)) {
      names.push_back(entry);
    } else {
      for (const std::string& letter : LettersIn(type, type.entry))
        names.push_back(entry + "." + letter);
    }
  }
  return names;
}

Span NameSpan(const TableColumn& column) {
  return {column.span.begin, column.span.begin + static_cast<uint32_t>(column.name.size())};
}

// The columns of a file: whether they are called as tables want them. Others may be there.
class FileCheck {
 public:
  FileCheck(const TableDeclaration& table, const std::vector<std::string>& wanted,
            const TaskScope& scope)
      : table_(table),
        columns_(table.source.file->columns.begin() + 1, table.source.file->columns.end()),
        wanted_(wanted),
        messages_(scope) {}

  std::vector<std::string> Check() {
    CheckRepeated();
    if (wanted_.size() == 1 && columns_.size() > 1 && !Has(wanted_.front())) {
      ReportChoice();
      return wanted_;
    }
    for (const TableColumn& column : columns_) {
      if (std::ranges::find(wanted_, column.name) != wanted_.end()) continue;
      const auto nearest = NearestMissing(column.name);
      if (!nearest) continue;
      messages_.Add(code::kBadColumn, NameSpan(column),
                    fmt::format("no table takes the column `{}`", column.name),
                    {.help = DidYouMean(NameSpan(column), *nearest),
                     .labels = {{table_.name.span, "for this table"}}});
      misspelled_.push_back(*nearest);
    }
    return misspelled_;
  }

 private:
  bool Has(const std::string& name) const {
    return std::ranges::find(columns_, name, &TableColumn::name) != columns_.end();
  }

  std::optional<std::string> NearestMissing(const std::string& name) const {
    std::vector<std::string> missing;
    std::ranges::copy_if(wanted_, std::back_inserter(missing),
                         [&](const std::string& each) { return !Has(each); });
    return text::NearestName(name, missing);
  }

  void CheckRepeated() {
    std::map<std::string, Span, std::less<>> seen;
    for (const TableColumn& column : columns_) {
      const auto [first, is_new] = seen.try_emplace(column.name, column.span);
      if (!is_new)
        messages_.Add(
            code::kBadColumn, column.span, fmt::format("there are two columns `{}`", column.name),
            {.help = "leave out one of them", .labels = {{first->second, "the first one"}}});
    }
  }

  // One number, and several columns.
  void ReportChoice() {
    messages_.Add(
        code::kBadColumn, columns_[1].span,
        "a table of a single number has one column beside its argument",
        {.help = fmt::format("leave out the others, or call the column `{}`", table_.name.text),
         .labels = {{table_.name.span, "for this table"}}});
  }

  const TableDeclaration& table_;
  const std::vector<TableColumn> columns_;  // without that of the argument
  const std::vector<std::string>& wanted_;
  TableMessages messages_;
  std::vector<std::string> misspelled_;
};

}  // namespace

// A single number is in the only column, or in that of the table's name; a vector may have its name
// before the letters.
std::vector<std::string> ColumnNames(const TableDeclaration& table, const Type& type,
                                     const TaskScope& scope) {
  const std::vector<TableColumn>& columns = table.source.file->columns;
  if (type.shape == Shape::kArray) return NamesInArray(type, scope);
  if (IsScalar(type)) return {columns.size() == 2 ? columns[1].name : table.name.text};
  const std::string prefix = table.name.text + ".";
  const bool has_prefix = std::ranges::any_of(
      columns, [&](const TableColumn& column) { return column.name.starts_with(prefix); });
  std::vector<std::string> names = LettersIn(type, type.shape);
  if (has_prefix)
    for (std::string& name : names) name.insert(0, prefix);
  return names;
}

std::vector<std::string> CheckColumns(const TableDeclaration& table,
                                      const std::vector<std::string>& wanted,
                                      const TaskScope& scope) {
  return FileCheck(table, wanted, scope).Check();
}

}  // namespace compiler
