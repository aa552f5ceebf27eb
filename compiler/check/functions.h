// The functions of a task: `fn near(distance: real [m]) -> real = ...`.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Adds names, parameters and results to the scope, so that a function can be called wherever it
// stands in the file.
void DeclareFunctions(const SyntaxTree& tree, TaskScope& scope);

// Checks what the declared functions compute, and that none calls itself; adds all of them to the
// task, in the order of the scope. To be called when params and memory are declared: a function
// that reads them gets a message that says what they are.
void CheckFunctions(const SyntaxTree& tree, const TaskScope& scope, CheckedTask& task);

// Keeps the functions that are called, each after those that it calls.
void KeepCalledFunctions(CheckedTask& task);

}  // namespace compiler
