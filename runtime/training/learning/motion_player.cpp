#include "runtime/training/learning/motion_player.h"

#include <fmt/format.h>

#include <utility>

namespace runtime {

MotionPlayer::MotionPlayer(std::string name, const Context& context)
    : MotionModule(std::move(name), context) {
  AddParameter({.name = "action_steps",
                .doc = "time steps of an action, for what a task pays once per action",
                .target = &action_steps_,
                .minimum = 1});
}

void MotionPlayer::StartOfEpisode() {
  BeginEpisode();
  steps_left_ = 0;
}

void MotionPlayer::Execute(const Eigen::VectorXd& action) {
  if (action.size() != motion().size()) {
    throw UserError(fmt::format("`{}` gets an action of {} numbers, and its motions have {}",
                                name(), action.size(), motion().size()));
  }
  motion().Take(action);
  frequency_ = motion().frequency();
  steps_left_ = action_steps_;
}

void MotionPlayer::StartOfTimeStep(double time_step) {
  if (steps_left_ > 0) Move(time_step);
}

void MotionPlayer::EndOfTimeStep(double) {
  CountTimeStep();
  if (steps_left_ == 0 || --steps_left_ > 0) return;
  end_of_action_();  // usually starts the next one
}

}  // namespace runtime
