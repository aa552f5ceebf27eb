// The least that an action space is: a module that nothing of the program knows.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"

namespace runtime {

// Holds the targets that it is given for a few time steps.
class HeldTargets : public Module {
 public:
  HeldTargets(std::string name, const Context& context)
      : Module(std::move(name)),
        targets_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(context.robot->joints.size()))) {
    AddParameter({.name = "steps", .doc = "of an action", .target = &steps_, .minimum = 1});
  }

 private:
  void Execute(const Eigen::VectorXd& targets) {
    targets_ = targets;
    left_ = steps_;
  }
  void EndTimeStep(double) {
    if (--left_ == 0) end_of_action_();
  }

  int steps_ = 8;
  int left_ = 0;
  Eigen::VectorXd targets_;
  Out<Eigen::VectorXd> joint_targets_{this, "joint_targets", &targets_};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&HeldTargets::Execute>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&HeldTargets::EndTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
};

}  // namespace runtime
