// The value of an expression of any shape that is known before the run.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

// Nothing for an expression that reads anything but `consts`. A scalar counts as itself, also where
// it stands for all elements of a shape. Numbers may be infinite or none.
std::optional<Value> ConstantValueOf(const CheckedExpression& expression,
                                     const std::vector<CheckedConst>& consts);

}  // namespace compiler
