// The page of a task.
#pragma once

#include "compiler/analyze/analyze.h"
#include "compiler/document/page.h"

namespace compiler {

// `analysis.task` must be there.
Page PageOf(const Analysis& analysis);

}  // namespace compiler
