// The order of a task in time: `phase lift within 3 s else reach { ... next done ... }`.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/log_table.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Adds the phases to the task, with the memory that they live in, and declares their names.
void DeclarePhases(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);

// Checks their blocks and limits, and lets that of the present phase run in each time step, after
// the task's own block. Precondition: the events have been checked.
void CheckPhases(const SyntaxTree& tree, LogTable& logs, TaskScope& scope, CheckedTask& task);

// Counts the time in the present phase, at the end of each time step and before all that reads it.
void AddPhaseClock(CheckedTask& task);

}  // namespace compiler
