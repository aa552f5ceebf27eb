// What the robot is told to do: `goal velocity: vec2 [m/s] = uniform(-1 m/s, 1 m/s) per 3 s .. 8
// s`.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Declares the goals and adds them to the task, with the memory that they live in.
void CheckGoals(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);

// The goal that `redraw` names, among those of the task. Reports and returns nothing where there is
// no such goal.
std::optional<uint32_t> FindGoal(const Identifier& name, const TaskScope& scope,
                                 const CheckedTask& task);

// Draws all goals at the start of an episode, before the task's own block, and those that have an
// interval at the end of the time step at which it is over, after the task's own block: what the
// step pays still belongs to the goal that the robot was told.
void AddGoalStatements(CheckedTask& task);

}  // namespace compiler
