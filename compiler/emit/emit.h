// Checked task to C++ text.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/text_writer.h"
#include "compiler/source/sources.h"

namespace compiler {

struct EmittedText {
  std::string text;
  std::vector<LineOrigin> origins;  // paths are those of the sources
};

// The whole C++ source of the plugin. It includes nothing but the ABI header, and its `#line`
// directives point into the task's files. The same task gives the same text, byte for byte.
std::string Emit(const CheckedTask& task, const Sources& sources);
// The same, and what its lines stand for.
EmittedText EmitWithOrigins(const CheckedTask& task, const Sources& sources);

}  // namespace compiler
