// The steps of functions that make one number out of many: `any`, `sum`, `norm`, `min` of an array.
#pragma once

#include <optional>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/builtin_emission.h"
#include "compiler/emit/cpp_text.h"
#include "compiler/emit/helper_functions.h"

namespace compiler {

// How the call makes one number out of the elements of its arguments; nothing where it does not.
// `min` and `max` do of one array, not of several values.
std::optional<Chain> ChainOf(const BuiltinCall& call);

// Whether it makes one number out of each vector of an array, as `norm` does.
bool IsOfEachVector(const BuiltinCall& call, const Chain& chain);

// The term of one element; `elements` has one text for each argument of the function.
CppText ChainTerm(Chain::Term term, const std::vector<CppText>& elements);

// The terms so far and one more.
CppText Combine(Chain::Join join, Scalar scalar, const CppText& so_far, const CppText& term,
                HelperSet& helpers);

// The result, once all terms are joined.
CppText FinishChain(Chain::Finish finish, const CppText& joined);

}  // namespace compiler
