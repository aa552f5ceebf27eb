// One client of `trainer environment`: a robot in its task for whoever is at the other end of a
// connection.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/core/module/module_graph.h"
#include "runtime/trainer/environment/client_messages.h"
#include "runtime/trainer/environment/outside_learner.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/task_modules.h"

namespace runtime {

// What all clients share, which outlives them.
struct SharedEnvironment {
  const TaskSetup& setup;
  TaskRecord task;
  double discount = 1;  // of potentials
};

// Throws CallError unless the agent's learner sees an observation and decides on vectors, so that
// somebody else can do so in its place.
void CheckCanBeOutside(const TaskSetup& setup);

class EnvironmentSession : private Outside {
 public:
  // Makes a graph of its own. Throws UserError.
  EnvironmentSession(const SharedEnvironment& shared, LocalSocket socket);

  // Serves the client until it is gone, in this thread. Throws UserError where the environment
  // cannot go on.
  void Run();
  // From any thread: as if the client was gone.
  void Interrupt() { messages_.Interrupt(); }

 private:
  struct IsResetAgain {};  // within an episode

  const Eigen::VectorXd& Begin(const Eigen::VectorXd& observation) override;
  const Eigen::VectorXd& Decide(const Eigen::VectorXd& observation, double reward) override;
  void End(const Eigen::VectorXd& observation, double reward) override;

  void Greet();
  void WaitForReset();
  void RunEpisodes();
  void RunEpisode();
  // The next action within an episode.
  const Eigen::VectorXd& WaitForStep();
  void NumberEpisode(const ResetRequest& reset);

  const SharedEnvironment& shared_;
  ClientMessages messages_;
  ModuleGraph graph_;
  Environment& environment_;
  OutsideLearner& learner_;
  TaskModules tasks_;
  int64_t number_ = 0;     // of the episode that was asked for last
  bool is_begun_ = false;  // the client has been told of it
  Eigen::VectorXd last_observation_;
  double last_reward_ = 0;
};

}  // namespace runtime
