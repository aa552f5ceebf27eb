#pragma once

#include <cstdint>
#include <string>

#include "runtime/core/module/context.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/learning/q_lambda.h"

namespace runtime {

// Selects actions by Boltzmann's distribution and learns from the rewards they bring
// (runtime/training/learning/q_lambda.h). Learning rate and temperature fall with the number of
// finished episodes.
//
// How an episode ends, after someone asked for it for the first time:
//   "after_action"  when the current action is over; its successor's value counts whatever the
//   end "immediate"     at once: the action is cut and learned from with what it brought; only a
//   truncated
//                   episode's last state has a value
class PengQLambda : public Learner {
 public:
  PengQLambda(std::string name, const Context& context);

  void Start() override;
  // theta (binary, after a line of text), the random numbers' state and the number of episodes.
  void Save(std::ostream& out) const override;
  // Throws UserError if the stream holds something else, and changes nothing then. Whether what was
  // learned fits the agent shows when the next episode starts.
  void Load(std::istream& in) override;

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override;
  void ForgetCredit() override { q_lambda_.ClearTraces(); }
  void Forget() override;
  // The learning rate is 0, and the temperature stays what it is.
  void StopLearning() override;

  // Finished episodes, also those of earlier runs that this one continues from.
  int64_t episode_count() const { return episodes_; }

  const QLambda& q_lambda() const { return q_lambda_; }
  double learning_rate() const;
  double temperature() const;

 private:
  void SelectFirst() override;
  void Execute() override { execute_(q_lambda_.action()); }
  void LearnAndSelect(double reward) override;
  void LearnFromEnd(double reward, const EpisodeEnd& end) override;
  void FinishEpisode() override;

  void PrepareTheta(int features);
  void NoteStep(bool has_learned) {
    if (!has_learned) NotePassedOver();
  }
  QLambda::Settings settings() const { return {discount_, trace_decay_, trace_max_}; }

  double discount_ = 0.9;
  double trace_decay_ = 0.9;
  double learning_rate_ = 0.3;
  double learning_rate_decay_ = 0.002;
  double learning_rate_min_ = 0.05;
  double temperature_ = 5;
  double temperature_decay_ = 0.004;
  double trace_max_ = 1;
  std::string episode_end_ = "after_action";

  QLambda q_lambda_;
  Random random_;
  int64_t episodes_ = 0;

  // Of the episode that ran last.
  double episode_learning_rate_ = 0;
  double episode_temperature_ = 0;

  In<Eigen::VectorXd> features_in_{this, "features"};
  In<int> action_count_in_{this, "action_count"};
  Signal<int> execute_{this, "execute"};
};

}  // namespace runtime
