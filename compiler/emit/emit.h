// Checked task to C++ text.
#pragma once

#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/source/sources.h"

namespace compiler {

// The whole C++ source of the plugin. It includes nothing but the ABI header, and its `#line`
// directives point into the task's files. The same task gives the same text, byte for byte.
std::string Emit(const CheckedTask& task, const Sources& sources);

}  // namespace compiler
