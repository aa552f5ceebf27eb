// What is set: a whole value or some of its elements, as in `place.xy += 1 m`, `touched[feet] =
// false`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/conversion.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// The dotted names of a target, one by one.
std::vector<Identifier> PathOf(const Target& target);

// What `target` means in `whole`, which is what the first `length` names of its path stand for.
// Reports a mistake, also an element that would be set twice, and then returns nothing.
std::optional<CheckedExpression> SelectTarget(CheckedExpression whole, const Target& target,
                                              size_t length, const TaskScope& scope);

// The elements that a selected target sets; empty: all.
std::vector<uint32_t> ElementsOf(const CheckedExpression& target);

// The value as it is set: one scalar for all elements of the target, one vector for each of its
// entries, or a value of its type.
// Reports and returns nothing where it does not fit.
std::optional<CheckedExpression> FitTo(Operand value, const CheckedExpression& selected,
                                       const Target& target, const TaskScope& scope);

}  // namespace compiler
