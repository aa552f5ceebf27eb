// Looks at how a run would start, before it does.
#pragma once

#include "runtime/trainer/setup/task_setup.h"

namespace runtime {

// Warns on the standard error stream of what `trainer robot show` finds wrong with the poses that
// episodes start from, in the run's profile. What a task draws beside its poses is left out.
void WarnOfStart(const TaskSetup& setup);

}  // namespace runtime
