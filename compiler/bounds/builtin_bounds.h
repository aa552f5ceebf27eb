// The bounds of what the functions of the language give.
#pragma once

#include <vector>

#include "compiler/bounds/interval.h"
#include "compiler/check/checked_task.h"

namespace compiler {

// `call`: for the types of its arguments; `arguments`: their bounds; `type`: of the result.
Box BuiltinBounds(const BuiltinCall& call, const std::vector<Box>& arguments, const Type& type);

}  // namespace compiler
