// The type and unit that a declaration gives: `real [m/s]`, `bool[link]`, `real[4]`.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

struct DeclaredType {
  Type type;
  Unit unit;
};

// Reports and returns nothing where there is no such type, or where it cannot have such a unit.
std::optional<DeclaredType> CheckDeclaredType(const TypeExpression& type,
                                              const std::optional<UnitExpression>& unit,
                                              const TaskScope& scope);

}  // namespace compiler
