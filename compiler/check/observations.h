// What the learner sees: `observe base.up`, `observe clock = sin(angle)`.
#pragma once

#include <cstdint>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// How many numbers a learner may see.
inline constexpr uint32_t kMostObserved = 65536;

void CheckObservations(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);

}  // namespace compiler
