#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "runtime/core/module/action_limits.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/dcob_actions.h"
#include "runtime/training/learning/dcob_motion.h"
#include "runtime/training/learning/gaussian_net.h"

namespace runtime {

// DCOB (dcob_motion.h) without a robot: what moves is a point, the observation, and an action moves
// it toward the center of a unit of the net. The environment is told in each time step where it is
// to be, or how far it is to move ("displacement").
//
//   in   observation, features, net: all of the same elements
//        limits: of the environment's actions, which have as many
//   out  action: for the environment; action_count: for the learner
class PointDcob : public Module {
 public:
  PointDcob(std::string name, const Context& context);

  void Start() override { ActionCount(); }

 private:
  void Execute(int action);
  void StartOfTimeStep(double time_step);
  void EndOfTimeStep(double time_step);
  // Checks the parameters when it is first asked for: modules may be started in any order.
  const int& ActionCount();
  void Prepare();

  std::vector<double> intervals_ = {0.3};
  double abbreviation_scale_ = 1;
  bool max_norm_ = false;
  std::string command_;

  DcobActions actions_;
  int action_count_ = 0;
  DcobMotion motion_;
  bool moving_ = false;
  Eigen::VectorXd start_;
  Eigen::VectorXd target_;
  Eigen::VectorXd action_;

  In<Eigen::VectorXd> observation_in_{this, "observation"};
  In<Eigen::VectorXd> features_in_{this, "features"};
  In<GaussianNet> net_in_{this, "net"};
  In<ActionLimits> limits_{this, "limits"};
  Out<Eigen::VectorXd> action_out_{this, "action", &action_};
  Out<int> action_count_out_{this, "action_count", Bind<&PointDcob::ActionCount>{}};
  Slot<int> execute_{this, "execute", Bind<&PointDcob::Execute>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step", Bind<&PointDcob::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&PointDcob::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

}  // namespace runtime
