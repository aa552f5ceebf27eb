// What a table's file holds, nothing resolved yet: named columns of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compiler/source/source_file.h"

namespace compiler {

// A cell of the first line: `left_knee [deg]`.
struct TableColumn {
  std::string name;
  Span span{};  // of the whole cell
  std::string unit{};
  Span unit_span{};  // with its brackets; empty: it has none
  bool has_unit() const { return unit_span.end > unit_span.begin; }
};

struct TableFile {
  std::vector<TableColumn> columns;  // that of the argument first; at least two
  std::vector<double> numbers;       // as written, row by row; finite
  std::vector<Span> rows;            // where they stand; at least two

  double At(size_t row, size_t column) const { return numbers[row * columns.size() + column]; }
};

}  // namespace compiler
