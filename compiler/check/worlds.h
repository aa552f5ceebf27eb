// The world that a task names: what can be sensed of its things.
#pragma once

#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/world/world_description.h"

namespace compiler {

// Makes the sensors of the world's things known. Reports a world without a robot, and a thing whose
// name the language needs. `world` may be null.
void CheckWorld(const SyntaxTree& tree, const world::WorldDescription* world, TaskScope& scope);

// Whether a declared sensor is one of the world's, or could be mistaken for it, which is reported.
bool IsOfWorld(const SensorDeclaration& sensor, const SyntaxTree& tree,
               const world::WorldDescription& world, TaskScope& scope);

}  // namespace compiler
