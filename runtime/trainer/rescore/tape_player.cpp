#include "runtime/trainer/rescore/tape_player.h"

#include <algorithm>

namespace runtime {
namespace {

// What ended the recorded episode may be no reason for the task that judges it.
constexpr EpisodeEnd kEndOfTape = {EndKind::kTruncated, "the recording ends"};

}  // namespace

void TapePlayer::Insert(const Tape& tape) {
  tape_ = &tape;
  discount_ = tape.discount;
  targets_.setZero(static_cast<Eigen::Index>(tape.joints));
}

void TapePlayer::StartOfEpisode() {
  step_ = 0;
  is_over_ = false;
  StartActions(false);
  if (tape_->steps() == 0) EndOfEpisode(kEndOfTape);
}

void TapePlayer::StartOfTimeStep(double) {
  if (is_over_) return;
  std::ranges::copy(tape_->TargetsOf(step_), targets_.begin());
}

// Where an episode may only end with an action, its last one is over now.
void TapePlayer::EndOfTimeStep(double) {
  if (is_over_) return;
  ++step_;
  StartActions(true);
  if (step_ < tape_->steps()) return;
  if (!tape_->ends_at_once) end_of_action_();
  EndOfEpisode(kEndOfTape);
}

void TapePlayer::EndOfEpisode(EpisodeEnd end) {
  if (is_over_) return;
  is_over_ = true;
  episode_over_(end);
}

void TapePlayer::StartActions(bool ends_one) {
  for (uint8_t started = 0; started < tape_->actions[step_]; ++started) {
    if (ends_one || started > 0) end_of_action_();
    start_of_action_();
  }
}

}  // namespace runtime
