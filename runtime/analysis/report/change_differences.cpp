#include "runtime/analysis/report/change_differences.h"

#include <map>
#include <set>

#include "runtime/analysis/report/version_difference.h"

namespace runtime {
namespace {

// Which task each module has, change by change.
class ModuleTasks {
 public:
  explicit ModuleTasks(const TaskRecord& first)
      : active_(first.module), tasks_{{first.module, first.id}} {}

  std::optional<TaskReplacement> Apply(const Change& change) {
    return std::visit([this](const auto& each) { return ApplyOne(each); }, change);
  }

 private:
  std::optional<TaskReplacement> ApplyOne(const SwapTask& swap) {
    return Put(swap.module, swap.task);
  }
  std::optional<TaskReplacement> ApplyOne(const RollBackTask& rollback) {
    return Put(rollback.module, rollback.task);
  }
  std::optional<TaskReplacement> ApplyOne(const LoadShadow& load) {
    tasks_[load.module] = load.task;
    return TaskReplacement{tasks_[active_], load.task};
  }
  std::optional<TaskReplacement> ApplyOne(const PromoteTask& promote) {
    const TaskReplacement replacement{tasks_[active_], tasks_[promote.module]};
    active_ = promote.module;
    return replacement;
  }
  std::optional<TaskReplacement> ApplyOne(const UnloadShadow& unload) {
    tasks_.erase(unload.module);
    return std::nullopt;
  }
  std::optional<TaskReplacement> ApplyOne(const SetParameter&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const ScheduleParameter&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const HoldGoal&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const ReleaseGoal&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const ConnectPorts&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const DisconnectPorts&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const AddModule&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const RemoveModule&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const PutInQuarantine&) { return std::nullopt; }
  std::optional<TaskReplacement> ApplyOne(const UnknownChange&) { return std::nullopt; }

  TaskReplacement Put(const std::string& module, int64_t task) {
    const TaskReplacement replacement{tasks_[module], task};
    tasks_[module] = task;
    return replacement;
  }

  std::string active_;
  std::map<std::string, int64_t> tasks_;
};

// What was never run again, since it had done harm.
class Quarantine {
 public:
  explicit Quarantine(const std::vector<ChangeRecord>& changes) {
    for (const ChangeRecord& change : changes) {
      const auto* quarantine = std::get_if<PutInQuarantine>(&change.change);
      if (quarantine == nullptr) continue;
      if (quarantine->task) tasks_.insert(*quarantine->task);
      if (quarantine->change) changes_.insert(*quarantine->change);
    }
  }

  bool Holds(const ChangeRecord& change) const {
    const std::optional<TaskOfModule> brought = TaskBroughtBy(change.change);
    return changes_.contains(change.id) || (brought && tasks_.contains(brought->task));
  }

 private:
  std::set<int64_t> tasks_;
  std::set<int64_t> changes_;
};

}  // namespace

std::vector<std::optional<TaskReplacement>> TaskReplacements(
    const RunRecord& run, const std::vector<ChangeRecord>& changes) {
  const auto task_count = static_cast<int64_t>(run.tasks.size());
  const auto is_known = [&](int64_t task) { return task >= 1 && task <= task_count; };
  const Quarantine quarantine(changes);
  ModuleTasks modules(run.tasks.front());
  std::vector<std::optional<TaskReplacement>> replacements(changes.size());
  for (size_t i = 0; i < changes.size(); ++i) {
    if (quarantine.Holds(changes[i])) continue;
    const std::optional<TaskReplacement> replaced = modules.Apply(changes[i].change);
    if (replaced && is_known(replaced->before) && is_known(replaced->after))
      replacements[i] = replaced;
  }
  return replacements;
}

std::vector<std::string> ChangeDifferences(const RunRecord& run,
                                           const std::vector<ChangeRecord>& changes) {
  std::vector<std::string> differences;
  for (const auto& replaced : TaskReplacements(run, changes)) {
    differences.push_back(replaced ? VersionDifference(run, TaskWithId(run, replaced->before),
                                                       TaskWithId(run, replaced->after))
                                   : "");
  }
  return differences;
}

}  // namespace runtime
