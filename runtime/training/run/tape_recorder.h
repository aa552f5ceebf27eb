// Keeps what the current episode is driven by.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "plugins/robot/start_state.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/tape.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {

class TapeRecorder {
 public:
  static constexpr double kMaximumDuration = 120;  // [s]; of a longer episode there is no tape

  // Refers to both, which must outlive it. Takes all memory that time steps will ever need in the
  // first one. Of an environment without a robot there is no tape.
  TapeRecorder(Environment& environment, const Learner& learner);

  // An episode has started, in what its task drew for it.
  void StartEpisode(const std::optional<robot::StartState>& drawn);
  // Call after the start of the episode, with 0, and after each time step, with their number.
  void Note(int64_t steps);

  // The episode, which is over, packed; "" where it had no time step or too many, where nothing
  // tells the joints anything, or where it has diverged: then it is not known what they were told
  // at last.
  std::string Finish() const;

 private:
  // Of the time step that is over. False where there are none.
  bool NoteTargets();

  RobotEnvironment* environment_;  // or null
  const Learner& learner_;
  const In<Eigen::VectorXd>* commands_ = nullptr;
  size_t most_steps_;
  bool is_whole_ = false;
  int actions_ = 0;  // that have started
  Tape tape_;
};

}  // namespace runtime
