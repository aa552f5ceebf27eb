#include "runtime/trainer/environment/outside_learner.h"

#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {

OutsideLearner::OutsideLearner(std::string name, Outside& outside, double discount)
    : Learner(std::move(name)), outside_(outside), discount_(discount) {}

void OutsideLearner::Start() { RequireConnections(*this); }

void OutsideLearner::SelectFirst() {
  told_ = 0;
  last_reward_ = 0;
  action_ = &outside_.Begin(observation_in_());
}

void OutsideLearner::LearnAndSelect(double reward) {
  told_ += reward;
  action_ = &outside_.Decide(observation_in_(), reward);
}

void OutsideLearner::LearnFromEnd(double reward, const EpisodeEnd&) { last_reward_ = reward; }

// Of an episode that has diverged nothing is learned, but who decides wants to know.
void OutsideLearner::FinishEpisode() {
  const bool has_diverged = episode_end().kind == EndKind::kDiverged;
  outside_.End(observation_in_(), has_diverged ? episode_return() - told_ : last_reward_);
}

}  // namespace runtime
