#include "runtime/training/learning/learner.h"

namespace runtime {

void Learner::Follow(const Learner& leader, int64_t number) {
  follows_ = true;
  Abandon();
  episode_ = number;
  ActLike(leader);
  SetNextEpisode(number);
}

void Learner::Abandon() {
  phase_ = Phase::kOver;
  early_end_.reset();
}

void Learner::TakeOver(const Learner& follower) {
  episode_ = follower.episode_;
  NoteEnd(follower.episode_end());
  return_ = follower.episode_return();
  reward_ = 0;
  actions_ = follower.actions_;
  passed_over_ = follower.passed_over_;
  Collect(follower);
  FinishEpisode();
}

void Learner::StartOfEpisode() {
  ++episode_;
  SelectFirst();
  phase_ = Phase::kRunning;
  end_.reset();
  if (early_end_) NoteEnd(*early_end_);
  early_end_.reset();
  reward_ = 0;
  return_ = 0;
  actions_ = 0;
  passed_over_ = 0;
  if (end_ && ends_at_once()) {
    Finish();
  } else {
    StartAction();
  }
}

void Learner::StartAction() {
  reward_ = 0;
  ++actions_;
  start_of_action_();
  if (phase_ == Phase::kRunning) Execute();
}

void Learner::Reward(double reward) {
  if (phase_ != Phase::kOver) reward_ += reward;
}

void Learner::EndOfAction() {
  if (phase_ != Phase::kRunning) return;
  if (end_) return Finish();
  LearnAndSelect(reward_);
  return_ += reward_;
  StartAction();
}

void Learner::EndOfEpisode(EpisodeEnd end) {
  const bool diverged = end.kind == EndKind::kDiverged;
  // A task hears of an episode's start before the learner does, and can end it right there.
  if (phase_ == Phase::kOver && !diverged) early_end_ = end;
  if (phase_ != Phase::kRunning) return;
  if (!end_ || diverged) {
    NoteEnd(end);
  }
  if (diverged || ends_at_once()) Finish();
}

void Learner::NoteEnd(const EpisodeEnd& end) {
  end_reason_ = end.reason;
  end_ = {end.kind, end_reason_.c_str()};
}

void Learner::Finish() {
  phase_ = Phase::kEnding;
  episode_over_(*end_);  // may still bring rewards
  if (end_->kind != EndKind::kDiverged && actions_ > 0) LearnFromEnd(reward_, *end_);
  return_ += reward_;
  reward_ = 0;
  if (!follows_) FinishEpisode();
  phase_ = Phase::kOver;
}

}  // namespace runtime
