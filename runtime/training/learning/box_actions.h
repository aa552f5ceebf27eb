#pragma once

#include <Eigen/Core>
#include <string>

#include "runtime/core/module/action_limits.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"

namespace runtime {

// An action space of vectors for an environment that takes vectors: an element from -1 to 1 is what
// lies between the environment's limits, and what is beyond is cut off. An action is held for
// `hold` time steps.
//
//   in   limits: of the environment's actions
//   out  action: for the environment; action_size: for the learner
class BoxActions : public Module {
 public:
  BoxActions(std::string name, const Context& context);

  void Start() override { ActionSize(); }

 private:
  void Execute(const Eigen::VectorXd& action);
  void EndOfTimeStep(double time_step);
  // When it is first asked for: modules may be started in any order.
  const int& ActionSize();

  int hold_ = 1;

  int action_size_ = 0;
  Eigen::VectorXd action_;
  int steps_left_ = 0;

  In<ActionLimits> limits_{this, "limits"};
  Out<Eigen::VectorXd> action_out_{this, "action", &action_};
  Out<int> action_size_out_{this, "action_size", Bind<&BoxActions::ActionSize>{}};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&BoxActions::Execute>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&BoxActions::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

}  // namespace runtime
