#include "runtime/training/run/task_modules.h"

#include <fmt/format.h>

#include "runtime/core/module/end_kind_name.h"

namespace runtime {
namespace {

bool Pays(const UniversalTask& task, const Learner& learner) {
  for (const Port* slot : task.reward.Connections()) {
    if (&slot->owner() == &learner) return true;
  }
  return false;
}

}  // namespace

TaskModules FindTaskModules(const ModuleGraph& graph, const Learner& learner) {
  using Role = UniversalTask::Role;
  const Role shadow =
      learner.ends_at_once() ? Role::kShadowEndsAtOnce : Role::kShadowEndsWithAction;
  TaskModules found;
  for (UniversalTask* task : graph.FindAll<UniversalTask>()) {
    const bool pays = Pays(*task, learner);
    task->SetRole(pays ? Role::kActive : shadow);
    task->FollowDiscount(learner.discount());
    if (pays && found.active == nullptr) {
      found.active = task;
    } else {
      found.shadows.push_back(task);
    }
  }
  if (found.active != nullptr) return found;
  throw UserError(
      fmt::format("no task pays the learner: connect the `reward` of a task module to "
                  "`{0}.reward`, and its `end_of_episode` to `{0}.end_of_episode`",
                  learner.name()));
}

Evaluation EvaluationOf(const UniversalTask& task) {
  Evaluation evaluation;
  evaluation.task = task.instance().id();
  evaluation.episode_return = task.episode_return();
  evaluation.end_kind = EndKindName(task.end().kind);
  evaluation.end_reason = task.end().reason;
  evaluation.faults = task.fault_count();
  for (const Incidents& violations : task.violations()) evaluation.violations += violations.count;
  evaluation.terms.assign(task.term_sums().begin(), task.term_sums().end());
  evaluation.metrics.assign(task.metrics().begin(), task.metrics().end());
  evaluation.logs.assign(task.logs().begin(), task.logs().end());
  evaluation.goals = task.instance().goals().draws();
  evaluation.phases = task.instance().phases().sums();
  return evaluation;
}

}  // namespace runtime
