// A learner whose decisions are made outside of the trainer.
#pragma once

#include <Eigen/Core>
#include <string>

#include "runtime/core/module/values.h"
#include "runtime/training/learning/learner.h"

namespace runtime {

// Its ports are those of a learner that sees an observation and whose actions are vectors, as
// Ppo's. Episodes end at once. When it is to decide it waits: an action begins by Decide(), between
// two time steps, right before the first one that it moves the robot in.
class OutsideLearner : public Learner {
 public:
  static constexpr const char* kType = "OutsideLearner";

  OutsideLearner(std::string name, double discount);

  void Start() override;

  int action_size() const { return action_size_in_(); }
  const Port& observation_port() const { return observation_in_; }

  // Whether no time step may be run before it is told what to do.
  bool is_asked() const { return is_asked_; }
  // Precondition: is_asked(); `action` has action_size() elements.
  void Decide(const Eigen::VectorXd& action);

  // What was seen when an episode began, an action was over, or the episode: whichever was last.
  const Eigen::VectorXd& observation() const { return observation_; }
  // What the action has brought that was over last, also with the episode; 0 before.
  double reward() const { return last_reward_; }

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  // It has learned nothing.
  void ForgetCredit() override {}
  void Forget() override {}
  void StopLearning() override {}

 private:
  void SelectFirst() override;
  void Execute() override { is_asked_ = true; }
  void LearnAndSelect(double reward) override;
  void LearnFromEnd(double reward, const EpisodeEnd& end) override;
  void FinishEpisode() override;

  const double discount_;
  bool is_asked_ = false;
  Eigen::VectorXd observation_;
  double told_ = 0;  // of the rewards of this episode
  double last_reward_ = 0;

  In<Eigen::VectorXd> observation_in_{this, "observation"};
  In<int> action_size_in_{this, "action_size"};
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace runtime
