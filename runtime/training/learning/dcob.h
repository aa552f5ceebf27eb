#pragma once

#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/dcob_actions.h"
#include "runtime/training/learning/dcob_motion.h"
#include "runtime/training/learning/dof_mapping.h"
#include "runtime/training/learning/gaussian_net.h"
#include "runtime/training/learning/state.h"

namespace runtime {

// The action space DCOB: with intervals g_0 .. g_{n-1} [s/rad], action a moves the coordinates
// toward the center of unit a / n at the pace g_{a mod n}
// (runtime/training/learning/dcob_motion.h).
//
// With the target "angles" (called DCOB-Q elsewhere) the distance D is that of the angles. With
// "state" (DCOB) it is that of the whole state, whose elements other than the angles are 0 in every
// center; the rates to arrive with are then the center's, which are 0 too. So the two differ only
// in how early a motion is cut short.
class Dcob : public Module {
 public:
  Dcob(std::string name, const Context& context);

  void Start() override;

 private:
  void Execute(int action);
  void StartOfTimeStep(double time_step);
  void EndOfTimeStep(double time_step);
  const int& ActionCount();

  // Checks the parameters and takes them over, when the action count is first asked for: modules
  // may be started in any order.
  void Prepare();
  double Distance(const Eigen::VectorXd& state);

  const robot::RobotDescription& robot_;
  std::vector<double> interval_parameter_ = {0.075, 0.1, 0.2};
  double abbreviation_scale_ = 1;
  bool max_norm_ = false;
  std::string target_parameter_ = "angles";

  DcobActions actions_;
  int action_count_ = 0;
  DofMapping mapping_;
  DcobMotion motion_;
  bool moving_ = false;
  Eigen::VectorXd start_;       // coordinates at the start of the motion
  Eigen::VectorXd target_;      // and those it goes to
  Eigen::VectorXd difference_;  // scratch: of two states
  Eigen::VectorXd joint_targets_;

  In<State> state_in_{this, "state"};
  In<Eigen::VectorXd> features_in_{this, "features"};
  In<GaussianNet> net_in_{this, "net"};
  Out<Eigen::VectorXd> joint_targets_out_{this, "joint_targets", &joint_targets_};
  Out<int> action_count_out_{this, "action_count", Bind<&Dcob::ActionCount>{}};
  Slot<int> execute_{this, "execute", Bind<&Dcob::Execute>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step", Bind<&Dcob::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&Dcob::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

}  // namespace runtime
