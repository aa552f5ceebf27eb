// Warnings that a task's author has silenced.
#pragma once

#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/source/sources.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `found` without the warnings that an `allow` around their place names, and with a warning for
// each code of an `allow` in the task's own file that silences nothing. What a file that the task
// imports or extends allows may be of use to that file alone.
Diagnostics ApplyAllowances(const std::vector<Allowance>& allowances, const Sources& sources,
                            const Diagnostics& found);

}  // namespace compiler
