// The declarations before the events: start pose, sensors, params, memory, metrics.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"

namespace compiler {

// Each function reports the mistakes in its part of the tree, and adds what is well declared to the
// scope and to the task.
void CheckSensors(const SyntaxTree& tree, const world::WorldDescription* world, TaskScope& scope);
void CheckParams(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);
void CheckMemory(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);
void CheckMetrics(const SyntaxTree& tree, TaskScope& scope, CheckedTask& task);

}  // namespace compiler
