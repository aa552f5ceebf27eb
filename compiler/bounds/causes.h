// Why a value has no bounds.
#pragma once

#include <vector>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/values.h"

namespace compiler {

// `locals`: the causes for each local. Empty where the value is bounded.
std::vector<Cause> CausesOf(const CheckedTask& task, const Values& values,
                            const std::vector<std::vector<Cause>>& locals,
                            const CheckedExpression& expression);

// Adds those that `causes` has not got yet.
void AddCauses(std::vector<Cause>& causes, const std::vector<Cause>& more);

}  // namespace compiler
