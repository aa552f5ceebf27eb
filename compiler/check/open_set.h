// A set that belongs to no array: what a loop goes through, what a `set` names.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/index_set.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// The numbers in such a set are below this.
inline constexpr uint32_t kNumbersOfOpenSet = 10'000;

struct OpenSet {
  const Enumeration* parts = nullptr;  // null: numbers
  std::vector<uint32_t> indices;       // in their order; never none
};

// Parts of the robot where one of the names says so, else numbers. Reports mistakes and then
// returns nothing.
std::optional<OpenSet> ResolveOpenSet(const std::vector<ExpressionPtr>& items, Span span,
                                      IndexUse use, const TaskScope& scope);

// The members of a set: "head", "3".
std::string MemberText(uint32_t index, const Enumeration* parts);

// Whether the name is that of a part of the robot or a group: `what` (such as "a set"), which is
// read in index sets as they are, cannot be called so. Reports where it is.
bool IsPartOfRobot(const Identifier& name, std::string_view what, const TaskScope& scope);

}  // namespace compiler
