// What the columns of a table's file are called.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// What the columns of the elements are called; the table has been read.
std::vector<std::string> ColumnNames(const TableDeclaration& table, const Type& type,
                                     const TaskScope& scope);

// Reports the columns that are there twice, and those that are not among `wanted`: what all tables
// of the file need together. Returns the names that misspelled ones should have. `table`: the
// first of the file.
std::vector<std::string> CheckColumns(const TableDeclaration& table,
                                      const std::vector<std::string>& wanted,
                                      const TaskScope& scope);

}  // namespace compiler
