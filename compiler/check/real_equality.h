// Comparisons that ask whether two real numbers are exactly equal.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Where what is compared was measured or computed from what was measured, it hardly ever is. Tests
// are left out: there every value is given.
void WarnOfRealEquality(const CheckedTask& task, Diagnostics& diagnostics);

}  // namespace compiler
