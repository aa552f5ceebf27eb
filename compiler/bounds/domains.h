// Functions whose argument can be something for which they have no value: `sqrt(x)` with x < 0.
#pragma once

#include <vector>

#include "compiler/bounds/bounds.h"
#include "compiler/bounds/values.h"
#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// Adds each such call in an expression to `left`. `definitions`: as Narrowing has them. What is
// looked at only if something else holds, in `and`, `or` and `select`, is looked at under that
// condition. An argument without any bound is no such one: about it nothing is known.
void FindLeftDomains(const CheckedTask& task, const Values& values,
                     const std::vector<const CheckedExpression*>& definitions,
                     const CheckedExpression& expression, std::vector<LeftDomain>& left);

void WarnOfLeftDomains(const TaskBounds& bounds, Diagnostics& diagnostics);

}  // namespace compiler
