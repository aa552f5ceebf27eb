#pragma once

#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/gaussian_net.h"
#include "runtime/training/learning/state.h"

namespace runtime {

// Features of a state: one of the robot's Gaussian networks over the coordinates' angles. Base and
// velocities do not matter.
class NgNet : public Module {
 public:
  NgNet(std::string name, const Context& context);

  void Start() override;

 private:
  // The net, made when it is first asked for: modules may be started in any order.
  const GaussianNet& Net();
  const Eigen::VectorXd& Features();

  const robot::NetDescription& FindNet() const;
  void RequireFit(const robot::NetDescription& net) const;

  const robot::RobotDescription& robot_;
  std::string net_name_ = "bq01";
  int net_seed_ = 1;
  bool max_norm_ = false;

  GaussianNet net_;
  Eigen::VectorXd features_;

  In<State> state_in_{this, "state"};
  Out<Eigen::VectorXd> features_out_{this, "features", Bind<&NgNet::Features>{}};
  Out<GaussianNet> net_out_{this, "net", Bind<&NgNet::Net>{}};
};

}  // namespace runtime
