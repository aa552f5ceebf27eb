// Drives a robot as a recorded episode was driven.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/run/tape.h"

namespace runtime {

// Takes the place of learner and action space: tells the environment the joint targets of a tape,
// and tasks when its actions started and ended, in the order in which a learner and an action space
// do; so it has to be connected behind the tasks. At the tape's end the episode is over.
class TapePlayer : public Module {
 public:
  explicit TapePlayer(std::string name) : Module(std::move(name)) {}

  // What plays in the next episode; outlives it.
  void Insert(const Tape& tape);
  const double& discount() const { return discount_; }
  bool is_over() const { return is_over_; }

 private:
  void StartOfEpisode();
  void StartOfTimeStep(double);
  void EndOfTimeStep(double);
  void EndOfEpisode(EpisodeEnd end);
  void StartActions(bool ends_one);

  const Tape* tape_ = nullptr;
  double discount_ = 1;
  size_t step_ = 0;
  bool is_over_ = true;
  Eigen::VectorXd targets_;

  Slot<> start_of_episode_{this, "start_of_episode", Bind<&TapePlayer::StartOfEpisode>{}};
  Slot<double> start_of_time_step_{this, "start_of_time_step",
                                   Bind<&TapePlayer::StartOfTimeStep>{}};
  Slot<double> end_of_time_step_{this, "end_of_time_step", Bind<&TapePlayer::EndOfTimeStep>{}};
  Slot<EpisodeEnd> end_of_episode_{this, "end_of_episode", Bind<&TapePlayer::EndOfEpisode>{}};
  Signal<> start_of_action_{this, "start_of_action"};
  Signal<> end_of_action_{this, "end_of_action"};
  Signal<EpisodeEnd> episode_over_{this, "episode_over"};
  Out<Eigen::VectorXd> joint_targets_{this, "joint_targets", &targets_};
};

}  // namespace runtime
