#include "runtime/trainer/environment/outside_learner.h"

#include <cassert>
#include <utility>

#include "runtime/core/module/connections.h"

namespace runtime {

OutsideLearner::OutsideLearner(std::string name, double discount)
    : Learner(std::move(name)), discount_(discount) {}

void OutsideLearner::Start() { RequireConnections(*this); }

void OutsideLearner::Decide(const Eigen::VectorXd& action) {
  assert(is_asked_);
  is_asked_ = false;
  execute_(action);
}

void OutsideLearner::SelectFirst() {
  is_asked_ = false;
  told_ = 0;
  last_reward_ = 0;
  observation_ = observation_in_();
}

void OutsideLearner::LearnAndSelect(double reward) {
  told_ += reward;
  last_reward_ = reward;
  observation_ = observation_in_();
}

void OutsideLearner::LearnFromEnd(double reward, const EpisodeEnd&) { last_reward_ = reward; }

// Of an episode that has diverged nothing is learned, but who decides wants to know.
void OutsideLearner::FinishEpisode() {
  const bool has_diverged = episode_end().kind == EndKind::kDiverged;
  if (has_diverged) last_reward_ = episode_return() - told_;
  observation_ = observation_in_();
}

}  // namespace runtime
