// Which warnings a task's author gets to see.
#pragma once

#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/source/sources.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `found` without the warnings that an `allow` around their place names, and with a warning for
// each code of an `allow` that silences nothing. All warnings are of the task's own file: those of
// what it imports or extends are the business of these files' authors.
Diagnostics ApplyAllowances(const std::vector<Allowance>& allowances, const Sources& sources,
                            const Diagnostics& found);

}  // namespace compiler
