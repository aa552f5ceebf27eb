// The functions of the language, applied to values.
#pragma once

#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/interpret/value.h"

namespace compiler {

// `function` with checked arguments; `type` is that of the result.
Value Apply(Builtin function, const std::vector<Value>& arguments, const Type& type);

}  // namespace compiler
