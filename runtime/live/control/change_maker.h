#pragma once

#include <filesystem>

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

  // `episode`: the first one that a schedule sets. Throws UserError, and changes nothing then;
  // RecordError where a plugin that the run has kept cannot be loaded.
  void Do(const Change& change, int64_t episode);

 private:
  // One for each kind.
  void Do(const SwapTask& change);
  void Do(const LoadShadow& change);
  void Do(const RollBackTask& change);
  void Do(const PromoteTask& change);
  void Do(const UnloadShadow& change);
  void Do(const SetParameter& change);
  void Do(const ConnectPorts& change);
  void Do(const DisconnectPorts& change);
  void Do(const AddModule& change);
  void Do(const RemoveModule& change);
  void Do(const UnknownChange& change);

  std::unique_ptr<TaskInstance> MakeInstance(int64_t task) const;
  std::shared_ptr<const Plugin> LoadKept(const TaskRecord& task) const;
  // What was learned from other rewards.
  void SettleLearner(const UniversalTask& task, bool forget);

  LiveGraph& graph_;
  Schedules& schedules_;
  const RunRecord& run_;
  const std::filesystem::path folder_;
};

}  // namespace runtime
