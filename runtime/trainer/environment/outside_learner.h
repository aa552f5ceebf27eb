// A learner whose decisions are made outside of the trainer.
#pragma once

#include <Eigen/Core>
#include <string>

#include "runtime/core/module/values.h"
#include "runtime/training/learning/learner.h"

namespace runtime {

// Who decides. The vectors that they get are valid during the call, those that they give until the
// next one. Whatever they throw ends the episode where it is.
class Outside {
 public:
  virtual ~Outside() = default;

  // An episode has begun, and is seen like this. Returns the first action.
  virtual const Eigen::VectorXd& Begin(const Eigen::VectorXd& observation) = 0;
  // The action is over, and has brought `reward`. Returns the next one.
  virtual const Eigen::VectorXd& Decide(const Eigen::VectorXd& observation, double reward) = 0;
  // The episode is over, and the last action has brought `reward`.
  virtual void End(const Eigen::VectorXd& observation, double reward) = 0;
};

// Its ports are those of a learner that sees an observation and whose actions are vectors, as
// Ppo's. Episodes end at once.
class OutsideLearner : public Learner {
 public:
  static constexpr const char* kType = "OutsideLearner";

  // `outside` outlives this object.
  OutsideLearner(std::string name, Outside& outside, double discount);

  void Start() override;

  int action_size() const { return action_size_in_(); }

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  // It has learned nothing.
  void ForgetCredit() override {}
  void Forget() override {}
  void StopLearning() override {}

 private:
  void SelectFirst() override;
  void Execute() override { execute_(*action_); }
  void LearnAndSelect(double reward) override;
  void LearnFromEnd(double reward, const EpisodeEnd& end) override;
  void FinishEpisode() override;

  Outside& outside_;
  const double discount_;
  const Eigen::VectorXd* action_ = nullptr;
  double told_ = 0;         // of the rewards
  double last_reward_ = 0;  // of the action at the end

  In<Eigen::VectorXd> observation_in_{this, "observation"};
  In<int> action_size_in_{this, "action_size"};
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace runtime
