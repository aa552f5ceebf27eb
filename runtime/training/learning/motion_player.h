#pragma once

#include <string>

#include "runtime/training/learning/motion_module.h"

namespace runtime {

// An action space of whole motions: an action is the vector of a motion's parameters, each in
// [-1, 1] (runtime/training/learning/parametric_motion.h).
//
// A motion's time is that since the start of the episode: it goes on from action to action, as long
// as these are the same, and so do the terms of a task that pay once per action.
class MotionPlayer : public MotionModule {
 public:
  MotionPlayer(std::string name, const Context& context);

 private:
  void StartOfEpisode();
  void Execute(const Eigen::VectorXd& action);
  void StartOfTimeStep(double time_step);
  void EndOfTimeStep(double time_step);
  const Eigen::VectorXd& Standstill() { return motion().standstill(); }

  int action_steps_ = 30;
  double frequency_ = 0;
  int steps_left_ = 0;  // of the action; 0: none runs

  Slot<> start_of_episode_{this, "start_of_episode", Bind<&MotionPlayer::StartOfEpisode>{}};
  Slot<const Eigen::VectorXd&> execute_{this, "execute", Bind<&MotionPlayer::Execute>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step",
                                   Bind<&MotionPlayer::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&MotionPlayer::EndOfTimeStep>{}};
  Signal<> end_of_action_{this, "end_of_action"};
  Out<Eigen::VectorXd> standstill_out_{this, "standstill", Bind<&MotionPlayer::Standstill>{}};
  Out<double> frequency_out_{this, "frequency", &frequency_};
};

}  // namespace runtime
