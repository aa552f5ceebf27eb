#pragma once

#include <string>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/dof_mapping.h"
#include "runtime/training/learning/parametric_motion.h"

namespace runtime {

// An action space of whole motions: an action is the vector of a motion's parameters, each in
// [-1, 1] (runtime/training/learning/parametric_motion.h).
//
// A motion's time is that since the start of the episode: it goes on from action to action, as long
// as these are the same, and so do the terms of a task that pay once per action. The joints'
// targets are the pose that the episode starts in, plus how far the motion moves the coordinates of
// the DoF configuration away from it, each within its stops. Coordinates range over the stops of
// the joint that stands for them, but not more than 2 rad to either side of their center.
class MotionPlayer : public Module {
 public:
  MotionPlayer(std::string name, const Context& context);

  // Throws UserError where the robot has no such DoF configuration, or the frequencies are none.
  void Start() override;

 private:
  void StartOfEpisode();
  void Execute(const Eigen::VectorXd& action);
  void StartOfTimeStep(double time_step);
  void EndOfTimeStep(double time_step);

  const robot::RobotDescription& robot_;
  std::string dof_name_ = "5";
  ParametricMotion::Settings settings_;
  int action_steps_ = 30;

  robot::DofConfiguration dof_;
  DofMapping mapping_;
  ParametricMotion motion_;
  Eigen::VectorXd low_, high_;    // stops of the joints
  Eigen::VectorXd rest_;          // of the coordinates
  Eigen::VectorXd rest_pose_;     // of the joints
  Eigen::VectorXd displacement_;  // scratch: of the coordinates
  Eigen::VectorXd standstill_;    // parameters
  Eigen::VectorXd joint_targets_;
  double frequency_ = 0;
  int64_t steps_ = 0;   // since the start of the episode
  int steps_left_ = 0;  // of the action; 0: none runs

  SensorIn joint_angle_;
  Slot<> start_of_episode_{this, "start_of_episode", Bind<&MotionPlayer::StartOfEpisode>{}};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&MotionPlayer::Execute>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step",
                                   Bind<&MotionPlayer::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&MotionPlayer::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
  Out<Eigen::VectorXd> joint_targets_out_{this, "joint_targets", &joint_targets_};
  Out<Eigen::VectorXd> standstill_out_{this, "standstill", &standstill_};
  Out<double> frequency_out_{this, "frequency", &frequency_};
};

}  // namespace runtime
