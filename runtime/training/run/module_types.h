#pragma once

#include "runtime/core/module/module_graph.h"

namespace runtime {

// All types of modules of this program that an agent file can name.
const ModuleTypes& ProgramModuleTypes();

}  // namespace runtime
