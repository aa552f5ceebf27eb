// What a task declares, as data for other programs: its params and what each is for, its reward
// terms, its metrics.
#pragma once

#include "compiler/analyze/analyze.h"
#include "compiler/report/report.h"

namespace compiler {

// The format is described in docs/taskc.md. `analysis.task` must be there.
Json ToJson(const Analysis& analysis);

}  // namespace compiler
