// Constant folding: what is known before the run is calculated before the run.
#pragma once

#include <optional>

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// The largest magnitude of an `int` constant: up to here a double tells all whole numbers apart.
inline constexpr double kLargestInt = 9007199254740991;  // 2^53 - 1

// The value of an expression that is a constant.
std::optional<double> ValueOf(const CheckedExpression& expression);

// `expression`, whose operands are folded already, as a constant where its operands are; `and` and
// `or` also where one operand decides. Nothing where the result would not be a finite number, or
// where the divisor is the constant 0: that has been reported.
std::optional<CheckedExpression> Fold(CheckedExpression expression, Diagnostics& diagnostics);

}  // namespace compiler
