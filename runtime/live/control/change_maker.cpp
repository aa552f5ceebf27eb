#include "runtime/live/control/change_maker.h"

#include <fmt/format.h>

#include "runtime/base/overloaded.h"
#include "runtime/core/task/plugin_watch.h"
#include "runtime/live/control/parameter_json.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {

ChangeMaker::ChangeMaker(LiveGraph& graph, Schedules& schedules, const RunRecord& run,
                         std::filesystem::path folder)
    : graph_(graph), schedules_(schedules), run_(run), folder_(std::move(folder)) {}

void ChangeMaker::Do(const Change& change, int64_t episode) {
  std::visit(Overloaded{
                 [&](const ScheduleParameter& each) {
                   graph_.FindParameter(each.parameter);  // throws where it is gone
                   schedules_.Set(each.parameter,
                                  {AsReal(each.from), AsReal(each.to), episode, each.episodes});
                 },
                 [](const PutInQuarantine&) {},  // concerns the journal alone
                 [&](const auto& each) { Do(each); },
             },
             change);
}

std::unique_ptr<TaskInstance> ChangeMaker::MakeInstance(int64_t task) const {
  const TaskRecord& record = TaskWithId(run_, task);
  return std::make_unique<TaskInstance>(LoadKept(record), task);
}

// It could be loaded when it was kept.
std::shared_ptr<const Plugin> ChangeMaker::LoadKept(const TaskRecord& task) const {
  const std::filesystem::path file = FindKeptPlugin(folder_, task.plugin);
  const InsideOfTask watched(task.id);  // its code runs already while it is loaded
  try {
    return std::make_shared<const Plugin>(file, task.task_file);
  } catch (const UserError& error) {
    throw RecordError(error.what());
  }
}

// The task that is there already stays, with its previous one: only what was learned from it may be
// forgotten.
void ChangeMaker::Do(const SwapTask& change) {
  const UniversalTask& task = graph_.FindTask(change.module);
  const bool is_there = task.instance().id() == change.task;
  if (is_there && !change.forget) return;
  if (!is_there) graph_.Swap(task.name(), MakeInstance(change.task));
  SettleLearner(task, change.forget);
}

void ChangeMaker::Do(const LoadShadow& change) {
  graph_.Load(change.module, MakeInstance(change.task));
}

// Back to the very task that was the previous one then: where a swap is left out, there may be
// nothing to do, or only another swap brings it.
void ChangeMaker::Do(const RollBackTask& change) {
  const UniversalTask& task = graph_.FindTask(change.module);
  if (task.instance().id() == change.task) return;
  const bool is_previous = task.previous() != nullptr && task.previous()->id() == change.task;
  if (is_previous) {
    graph_.Rollback(task.name());
  } else {
    graph_.Swap(task.name(), MakeInstance(change.task));
  }
  SettleLearner(task, false);
}

void ChangeMaker::Do(const PromoteTask& change) {
  graph_.Promote(change.module);
  SettleLearner(graph_.FindTask(change.module), change.forget);
}

void ChangeMaker::SettleLearner(const UniversalTask& task, bool forget) {
  if (&task != &graph_.active_task()) return;
  graph_.learner().ForgetCredit();
  if (forget) graph_.learner().Forget();
}

void ChangeMaker::Do(const UnloadShadow& change) { graph_.Unload(change.module); }

void ChangeMaker::Do(const SetParameter& change) {
  const Parameter& parameter = graph_.FindParameter(change.parameter);
  graph_.Set(change.parameter, FitTo(parameter, change.value, change.parameter));
  schedules_.Remove(change.parameter);
}

void ChangeMaker::Do(const ConnectPorts& change) { graph_.Connect(change.first, change.second); }

void ChangeMaker::Do(const DisconnectPorts& change) {
  graph_.Disconnect(change.first, change.second);
}

void ChangeMaker::Do(const AddModule& change) {
  graph_.AddModule(change.type, change.module, change.parameters);
}

void ChangeMaker::Do(const RemoveModule& change) { graph_.RemoveModule(change.module); }

void ChangeMaker::Do(const UnknownChange& change) {
  throw UserError(fmt::format("this version of the trainer knows no change `{}`", change.kind));
}

}  // namespace runtime
