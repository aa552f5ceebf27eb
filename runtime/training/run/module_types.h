#pragma once

#include "runtime/core/module/network.h"

namespace runtime {

// All types of modules of this program that an agent file can name.
const ModuleTypes& ProgramModuleTypes();

}  // namespace runtime
