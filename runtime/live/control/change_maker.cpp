#include "runtime/live/control/change_maker.h"

#include <fmt/format.h>

#include "runtime/core/task/plugin_watch.h"
#include "runtime/live/control/parameter_json.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {

ChangeMaker::ChangeMaker(LiveGraph& graph, Schedules& schedules, const RunRecord& run,
                         std::filesystem::path folder)
    : graph_(graph), schedules_(schedules), run_(run), folder_(std::move(folder)) {}

void ChangeMaker::Do(const Change& change, const Circumstances& circumstances) {
  std::visit([&](const auto& each) { Apply(each, circumstances); }, change);
}

std::unique_ptr<TaskInstance> ChangeMaker::MakeInstance(
    int64_t task, std::shared_ptr<const Plugin> loaded) const {
  if (loaded == nullptr) loaded = LoadKept(TaskWithId(run_, task));
  return std::make_unique<TaskInstance>(std::move(loaded), task);
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
void ChangeMaker::Apply(const SwapTask& change, const Circumstances& circumstances) {
  const UniversalTask& task = graph_.FindTask(change.module);
  const bool is_there = task.instance().id() == change.task;
  if (is_there && !change.forget) return;
  if (!is_there) graph_.Swap(task.name(), MakeInstance(change.task, circumstances.plugin));
  SettleLearner(task, change.forget);
}

void ChangeMaker::Apply(const LoadShadow& change, const Circumstances& circumstances) {
  graph_.Load(change.module, MakeInstance(change.task, circumstances.plugin));
}

// Back to the very task that was the previous one then: where a swap is left out, there may be
// nothing to do, or only another swap brings it.
void ChangeMaker::Apply(const RollBackTask& change, const Circumstances& circumstances) {
  const UniversalTask& task = graph_.FindTask(change.module);
  if (task.instance().id() == change.task) return;
  const bool is_previous = task.previous() != nullptr && task.previous()->id() == change.task;
  if (is_previous) {
    graph_.Rollback(task.name());
  } else {
    graph_.Swap(task.name(), MakeInstance(change.task, circumstances.plugin));
  }
  SettleLearner(task, false);
}

void ChangeMaker::Apply(const PromoteTask& change, const Circumstances&) {
  graph_.Promote(change.module);
  SettleLearner(graph_.FindTask(change.module), change.forget);
}

void ChangeMaker::SettleLearner(const UniversalTask& task, bool forget) {
  if (&task != &graph_.active_task()) return;
  graph_.learner().ForgetCredit();
  if (forget) graph_.learner().Forget();
}

void ChangeMaker::Apply(const UnloadShadow& change, const Circumstances&) {
  graph_.Unload(change.module);
}

void ChangeMaker::Apply(const SetParameter& change, const Circumstances&) {
  graph_.Set(change.parameter, change.value);
  schedules_.Remove(change.parameter);
}

void ChangeMaker::Apply(const ScheduleParameter& change, const Circumstances& circumstances) {
  graph_.FindParameter(change.parameter);  // throws where it is gone
  schedules_.Set(change.parameter,
                 {AsReal(change.from), AsReal(change.to), circumstances.episode, change.episodes});
}

void ChangeMaker::Apply(const HoldGoal& change, const Circumstances&) {
  graph_.HoldGoal(change.goal, NumbersIn(change.value, change.goal));
}

void ChangeMaker::Apply(const ReleaseGoal& change, const Circumstances&) {
  graph_.ReleaseGoal(change.goal);
}

void ChangeMaker::Apply(const ConnectPorts& change, const Circumstances&) {
  graph_.Connect(change.first, change.second);
}

void ChangeMaker::Apply(const DisconnectPorts& change, const Circumstances&) {
  graph_.Disconnect(change.first, change.second);
}

void ChangeMaker::Apply(const AddModule& change, const Circumstances&) {
  graph_.AddModule(change.type, change.module, change.parameters);
}

void ChangeMaker::Apply(const RemoveModule& change, const Circumstances&) {
  graph_.RemoveModule(change.module);
}

void ChangeMaker::Apply(const UnknownChange& change, const Circumstances&) {
  throw UserError(fmt::format("this version of the trainer knows no change `{}`", change.kind));
}

}  // namespace runtime
