// Checked task to C++ text.
#pragma once

#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/source/source_file.h"

namespace compiler {

// The whole C++ source of the plugin. It includes nothing but the ABI header, and its `#line`
// directives point into the `.task` file. The same task gives the same text, byte for byte.
std::string Emit(const CheckedTask& task, const SourceFile& source);

}  // namespace compiler
