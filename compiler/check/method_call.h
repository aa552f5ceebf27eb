// `v.norm()`, `math.sqrt(x)`, `joint.angle(hip)`: calls of other languages.
#pragma once

#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Reports such a call, with what is written here. `span`: of the whole.
void ReportMethodCall(const MethodExpression& method, Span span, const TaskScope& scope);

// Reports `contact(head)`, parentheses where brackets are meant, and returns true; false where the
// called name is not of a value with elements.
bool ReportCalledArray(const CallExpression& call, Span span, const TaskScope& scope);

}  // namespace compiler
