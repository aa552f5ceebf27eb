// Syntax tree to checked task.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/check/references.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"

namespace compiler {

// Checks names, types, shapes, index ranges and units. `robot` is the description of the robot that
// the task names, or null if it names none or that is nowhere. All mistakes go to `diagnostics`,
// which may hold errors of what was done before; returns nothing if any of them was an error. What
// the tree has lost is not missed. What the names stand for goes to `references`, as far as it is
// known. `world`: that which the task names, or null likewise.
std::optional<CheckedTask> Check(const SyntaxTree& tree, const robot::RobotDescription* robot,
                                 Diagnostics& diagnostics, References* references = nullptr,
                                 const world::WorldDescription* world = nullptr);

}  // namespace compiler
