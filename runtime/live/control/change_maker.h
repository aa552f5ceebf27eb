#pragma once

#include <filesystem>
#include <memory>

#include "runtime/core/task/plugin.h"
#include "runtime/live/control/live_graph.h"
#include "runtime/live/control/schedules.h"
#include "runtime/training/run/change.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// Does changes to a running graph, the first time and again.
class ChangeMaker {
 public:
  // `folder`: of the run, with its plugins. All of these outlive this object.
  ChangeMaker(LiveGraph& graph, Schedules& schedules, const RunRecord& run,
              std::filesystem::path folder);

  // What a change meets when it is done.
  struct Circumstances {
    int64_t episode = 0;  // the first one that a schedule sets
    // Of the task that comes, where it is loaded already; otherwise what the run has kept is
    // loaded.
    std::shared_ptr<const Plugin> plugin;
  };

  // Throws UserError, and changes nothing then; RecordError where a plugin that the run has kept
  // cannot be loaded.
  void Do(const Change& change, const Circumstances& circumstances);

  // Throws RecordError where it is gone or was changed.
  std::shared_ptr<const Plugin> LoadKept(const TaskRecord& task) const;

 private:
  // One for each kind.
  void Apply(const SwapTask& change, const Circumstances& circumstances);
  void Apply(const LoadShadow& change, const Circumstances& circumstances);
  void Apply(const RollBackTask& change, const Circumstances& circumstances);
  void Apply(const PromoteTask& change, const Circumstances&);
  void Apply(const UnloadShadow& change, const Circumstances&);
  void Apply(const SetParameter& change, const Circumstances&);
  void Apply(const ScheduleParameter& change, const Circumstances& circumstances);
  void Apply(const HoldGoal& change, const Circumstances&);
  void Apply(const ReleaseGoal& change, const Circumstances&);
  void Apply(const ConnectPorts& change, const Circumstances&);
  void Apply(const DisconnectPorts& change, const Circumstances&);
  void Apply(const AddModule& change, const Circumstances&);
  void Apply(const RemoveModule& change, const Circumstances&);
  void Apply(const PutInQuarantine&, const Circumstances&) {}  // concerns the journal alone
  void Apply(const UnknownChange& change, const Circumstances&);

  std::unique_ptr<TaskInstance> MakeInstance(int64_t task,
                                             std::shared_ptr<const Plugin> loaded) const;
  // What was learned from other rewards.
  void SettleLearner(const UniversalTask& task, bool forget);

  LiveGraph& graph_;
  Schedules& schedules_;
  const RunRecord& run_;
  const std::filesystem::path folder_;
};

}  // namespace runtime
