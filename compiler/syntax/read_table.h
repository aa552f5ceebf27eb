// CSV to a table: a line of names, then lines of numbers, with commas between the cells.
#pragma once

#include <optional>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/table_file.h"

namespace compiler {

// The numbers of a table, with those of its argument. More would take long to compile.
inline constexpr size_t kMostTableNumbers = 100'000;
// As large as a number in a table may be, in the unit in which it is written: differences of two
// stay finite in any unit.
inline constexpr double kLargestTableNumber = 1e100;

// The rows of `source`, whose first column grows from one to the next. Nothing, after a few
// messages, where it is no table.
std::optional<TableFile> ReadTable(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace compiler
