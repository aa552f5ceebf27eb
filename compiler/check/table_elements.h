// The numbers of a table, as the elements of its type.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/declared_type.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Finds the column of each element, and brings the numbers to SI units. Reports and returns nothing
// where columns, units or rotations are wrong. `misspelled`: names of columns that are no more
// missed.
std::optional<CheckedTable> ResolveElements(const TableDeclaration& table,
                                            const DeclaredType& declared,
                                            const std::vector<std::string>& misspelled,
                                            const TaskScope& scope);

}  // namespace compiler
