// What operators and functions make of single values. Folded constants and the evaluator use the
// same arithmetic, and what is emitted gives the same bits.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/check/checked_task.h"

namespace compiler {

// Ints wrap around. A bool is 0 or 1, among ints as among reals.
double Calculate(UnaryOperator op, double operand);
int64_t Calculate(UnaryOperator op, int64_t operand);

// The results of comparisons and of logic are 0 or 1. Ints are never divided: the checker makes
// reals of them first.
double Calculate(BinaryOperator op, double left, double right);
int64_t Calculate(BinaryOperator op, int64_t left, int64_t right);
// Whether a comparison of reals holds.
bool Holds(BinaryOperator comparison, double left, double right);

// A function of the given values: the arguments of `clamp`, the elements of an array for `sum`.
// What joins many values joins them from the left. At least one value; only functions whose
// arguments can be written in one row like that, so neither `norm` nor `dot` nor `cross` nor a
// vector.
double Calculate(Builtin function, std::span<const double> values);
int64_t Calculate(Builtin function, std::span<const int64_t> values);

}  // namespace compiler
