#pragma once

#include "runtime/core/module/module_graph.h"

namespace runtime {

// Adds the modules of this folder: DofState, NgNet, Dcob, PengQLambda, JointOffsets,
// Ppo.
void AddLearningModules(ModuleTypes& types);

}  // namespace runtime
