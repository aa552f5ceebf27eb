// What a `for` goes through: the values of its variable, known before the run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// So many statements a task may have when its loops are written out.
inline constexpr uint32_t kMostStatements = 10'000;
// So many operators, calls and operands its loops may have then.
inline constexpr uint32_t kMostLoopParts = 100'000;

// The variable's value in one pass.
struct LoopValue {
  std::string text;  // "head", "3"
  Symbol symbol;
};

// The values in their order; never none. Parts of the robot where one of the names says so, else
// numbers. Reports mistakes and then returns nothing.
std::optional<std::vector<LoopValue>> ResolveLoop(const ForStatement& loop, const TaskScope& scope);

// The variable of a loop whose values are not known: what depends on it is not reported.
Symbol UnknownLoopVariable();

// Can the variable be called so? It is read in index sets, so it cannot have the name of a part
// of the robot or of a group either. Reports where it cannot.
bool CheckLoopVariable(const Identifier& variable, TaskScope& scope);

}  // namespace compiler
