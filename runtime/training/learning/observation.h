#pragma once

#include <Eigen/Core>
#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/robot_observation.h"

namespace runtime {

// What a learner sees, as one vector (runtime/training/learning/robot_observation.h).
//
//   in   one port for each of the robot's sensors that it reads
//   out  observation: the vector as of now, computed each time it is read. A learner reads it when
//        it decides: when an episode has started, when an action is over and, to value what may
//        come next, when the episode is over
class Observation : public Module {
 public:
  Observation(std::string name, const Context& context);

  void Start() override;

  const Eigen::VectorXd& Read();

 private:
  RobotObservation robot_;
  Out<Eigen::VectorXd> observation_{this, "observation", Bind<&Observation::Read>{}};
  Eigen::VectorXd values_;
};

}  // namespace runtime
