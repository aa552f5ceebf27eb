// The blocks of the events and phases.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/log_table.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Checks every `on EVENT { ... }`; adds events, reward terms and ends to the task.
void CheckEvents(const SyntaxTree& tree, LogTable& logs, TaskScope& scope, CheckedTask& task);

// Checks the block of a phase as one of `end_of_time_step`, and adds reward terms and ends.
CheckedBlock CheckPhaseBlock(const PhaseDeclaration& phase, LogTable& logs, TaskScope& scope,
                             CheckedTask& task);

// Checks the block of a start, in which `table` says what can be set.
void CheckStartBlock(const Block& block, const StartTable& table, LogTable& logs, TaskScope& scope,
                     CheckedTask& task);

}  // namespace compiler
