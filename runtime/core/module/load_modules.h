#pragma once

#include <filesystem>

#include "runtime/core/module/module_graph.h"

namespace runtime {

// Adds the types of a library (module_library.h), which stays loaded until the program ends. Throws
// UserError, which names the file and the remedy, where it cannot be loaded, was made for another
// version or by another compiler, or has a type that there is already. What its own code does when
// it is loaded is not under control: load only libraries that you trust.
void LoadModules(const std::filesystem::path& library, ModuleTypes& types);

}  // namespace runtime
