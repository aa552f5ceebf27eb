#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "runtime/core/module/action_limits.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"

namespace runtime {

// An action space of indices for an environment that takes vectors: action i is the i-th of a list
// of vectors, held for `hold` time steps.
//
//   in   limits: of the environment's actions, whose size the vectors have
//   out  action: for the environment; action_count: for the learner
class ActionTable : public Module {
 public:
  ActionTable(std::string name, const Context& context);

  void Start() override { ActionCount(); }

 private:
  void Execute(int action);
  void EndOfTimeStep(double time_step);
  // Checks the parameters when it is first asked for: modules may be started in any order.
  const int& ActionCount();
  void Prepare();

  std::vector<double> actions_;
  int hold_ = 1;

  int action_count_ = 0;
  Eigen::VectorXd action_;
  int steps_left_ = 0;

  In<ActionLimits> limits_{this, "limits"};
  Out<Eigen::VectorXd> action_out_{this, "action", &action_};
  Out<int> action_count_out_{this, "action_count", Bind<&ActionTable::ActionCount>{}};
  Slot<int> execute_{this, "execute", Bind<&ActionTable::Execute>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&ActionTable::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

}  // namespace runtime
