// Warnings that a task's author has silenced.
#pragma once

#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `found` without the warnings that an `allow` around their place names, and with a warning for
// each code of an `allow` that silences nothing.
Diagnostics ApplyAllowances(const std::vector<Allowance>& allowances, const Diagnostics& found);

}  // namespace compiler
