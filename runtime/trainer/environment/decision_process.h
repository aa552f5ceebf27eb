// An agent's environment as a learner outside of it knows one: reset, and a step for each decision.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/module/observations.h"
#include "runtime/core/module/values.h"
#include "runtime/core/task/universal_task.h"
#include "runtime/trainer/environment/outside_learner.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/task_modules.h"

namespace runtime {

// Throws CallError unless the agent's learner sees an observation and decides on vectors, so that
// somebody else can do so in its place.
void CheckCanBeOutside(const TaskSetup& setup);

// One robot in its task. The same episode of a run with the seed of the setup's context, in which
// the same is decided, goes and is paid in exactly this way.
class DecisionProcess {
 public:
  // Makes a graph of its own. `discount`: of potentials. `setup` outlives this object, and may be
  // shared by several threads. Throws UserError.
  DecisionProcess(const TaskSetup& setup, double discount);

  int action_size() const { return learner_.action_size(); }
  ObservationLayout observation_layout() const;
  const ModuleGraph& graph() const { return graph_; }
  const Environment& environment() const { return environment_; }
  const UniversalTask& task() const { return *tasks_.active; }

  // The number of the episode that a seed stands for: one more, of its lower 53 bits.
  static int64_t NumberOf(uint64_t seed) {
    return static_cast<int64_t>(seed & ((uint64_t{1} << 53) - 1)) + 1;
  }
  // Begins the episode of this number, from 1 on; one that runs is given up. It may be over where
  // it begins. Throws UserError where the environment cannot go on; then, and after a Step() that
  // has thrown, an episode is to be begun.
  void Reset(int64_t number);
  // Precondition: is_running(); `action` has action_size() elements. Runs time steps until the next
  // decision is due, or the episode is over.
  void Step(const Eigen::VectorXd& action);

  // Sets a parameter of a module, "task.weight", from now on. Throws as SetLive(), and changes
  // nothing then.
  void Set(const std::string& parameter, const ParameterValue& value);
  ParameterValue Get(const std::string& parameter) const;

  bool is_running() const { return is_running_; }
  // The number of the episode that runs or ran last; 0 before the first one.
  int64_t number() const { return number_; }
  // As of now; valid until the next call.
  const Eigen::VectorXd& observation() const { return learner_.observation(); }
  // What the last action has brought.
  double reward() const { return learner_.reward(); }
  // Of the episode that was over last. Precondition: there is one.
  const EpisodeRecord& record() const { return record_; }
  EndKind end_kind() const { return end_kind_; }

 private:
  void EndIfOver();

  ModuleGraph graph_;
  Environment& environment_;
  OutsideLearner& learner_;
  TaskModules tasks_;
  int64_t number_ = 0;
  int64_t steps_ = 0;
  bool is_running_ = false;
  EpisodeRecord record_;
  EndKind end_kind_ = EndKind::kTruncated;
};

}  // namespace runtime
