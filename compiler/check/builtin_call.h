// Calls of functions: do the arguments fit, and what comes out.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/builtins.h"
#include "compiler/check/checked_task.h"
#include "compiler/check/conversion.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// A call with checked arguments. `min` and `max` of more than two values become nested calls of
// two. Reports and returns nothing where the arguments do not fit.
std::optional<CheckedExpression> CheckBuiltin(const BuiltinDescription& builtin, Span span,
                                              std::vector<Operand> arguments,
                                              Diagnostics& diagnostics);

}  // namespace compiler
