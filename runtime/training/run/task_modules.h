// The task modules of a graph, and which of them pays the learner.
#pragma once

#include <vector>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

struct TaskModules {
  UniversalTask* active = nullptr;  // the first whose reward reaches the learner
  std::vector<UniversalTask*> shadows;
};

// Also tells each of them its role, and the learner's discount. Throws UserError where no task pays
// the learner.
TaskModules FindTaskModules(const ModuleGraph& graph, const Learner& learner);

// What a task module says of the episode that has just ended for it.
Evaluation EvaluationOf(const UniversalTask& task);

}  // namespace runtime
