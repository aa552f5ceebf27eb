// What a learner sees, as one vector.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/observations.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/robot_observation.h"

namespace runtime {

// What the task observes or, where it observes nothing, the robot (RobotObservation). Without a
// robot it has to observe something.
//
//   in   task: what the task that pays the learner observes
//        one port for each of the robot's sensors that RobotObservation reads; to be connected
//        where the task observes nothing
//        phase: of a motion that the robot is moved by (motion_generator.h), seen beside the rest
//        if it is connected
//   out  observation: the vector as of now, computed each time it is read. A learner reads it when
//        it decides: when an episode has started, when an action is over and, to value what may
//        come next, when the episode is over; always after the task has heard of that
//        layout: what it consists of; from the moment at which all ports are connected
//
// The layout stays the same while a run lasts: a task that observes something else is refused by
// CheckSameLayout(), before it takes the place of the old one.
class Observation : public Module {
 public:
  Observation(std::string name, const Context& context);

  void Start() override;

  // Throws UserError where there is nothing to see.
  const ObservationLayout& Layout();
  const Eigen::VectorXd& Read();

 private:
  In<TaskObservations> task_{this, "task"};
  std::optional<RobotObservation> robot_;  // where there is a robot
  In<Eigen::VectorXd> phase_{this, "phase", "", In<Eigen::VectorXd>::Need::kOptional};
  Out<Eigen::VectorXd> observation_{this, "observation", Bind<&Observation::Read>{}};
  Out<ObservationLayout> layout_port_{this, "layout", Bind<&Observation::Layout>{}};

  ObservationLayout layout_;  // empty before it is asked for
  bool is_of_task_ = false;
  Eigen::VectorXd values_;
  Eigen::VectorXd of_robot_;  // the part of it that shows the robot
};

}  // namespace runtime
