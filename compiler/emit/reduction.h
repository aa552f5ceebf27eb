// Functions that make one number out of many: `any`, `sum`, `norm`, `min` of an array, ...
//
// Each is a chain: a term for every element, the terms joined from the left, and one last step.
#pragma once

#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/cpp_text.h"
#include "compiler/emit/helper_functions.h"

namespace compiler {

// `min` and `max` are reductions of one array, and plain functions of several values.
bool IsReduction(const BuiltinCall& call);

// The term of one element; `elements` has one text for each argument of the function.
CppText ReductionTerm(Builtin function, const std::vector<CppText>& elements);

// The terms so far and one more. Also joins the arguments of `min` and `max`.
CppText Combine(Builtin function, Scalar scalar, const CppText& so_far, const CppText& term,
                HelperSet& helpers);

// The result, once all terms are joined.
CppText FinishReduction(Builtin function, const CppText& joined);

}  // namespace compiler
