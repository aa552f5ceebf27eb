#include "compiler/document/page_builder.h"

#include <algorithm>
#include <cstddef>

namespace compiler {

void PageBuilder::AddHeading(std::string text) { Add(Heading{2, Plain(std::move(text))}); }

void PageBuilder::AddFormulas(const std::vector<Equation>& equations) {
  Formulas formulas;
  for (const Equation& equation : equations) {
    formulas.lines.push_back(
        {equation.left, "=", equation.right, "", equation.reads, equation.let});
  }
  Add(std::move(formulas));
}

void PageBuilder::AddTable(Table table) {
  for (size_t column = table.header.size(); column-- > 0;) {
    const auto is_blank = [&](const std::vector<Text>& row) {
      return std::ranges::all_of(row[column], [](const Piece& p) { return p.text.empty(); });
    };
    if (!std::ranges::all_of(table.rows, is_blank)) continue;
    table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(column));
    for (auto& row : table.rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  }
  Add(std::move(table));
}

void PageBuilder::AddSection(std::string heading, Table table) {
  if (table.rows.empty()) return;
  AddHeading(std::move(heading));
  AddTable(std::move(table));
}

}  // namespace compiler
