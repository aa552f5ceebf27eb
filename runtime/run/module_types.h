#pragma once

#include "runtime/module/network.h"

namespace runtime {

// Adds all types of modules that an agent file can name.
void RegisterModuleTypes(ModuleTypes& types);

}  // namespace runtime
