// Proximal policy optimization of a Gaussian policy: one update from a batch of decisions.
//
//   1. values v of all observations; rewards divided by the deviation of discounted returns
//   2. advantages a by GAE (runtime/training/learning/gae.h), targets of the value a + v; then the
//      advantages get mean 0 and deviation 1
//   3. `epochs` times, in minibatches drawn at random: a step of Adam down the policy's and the
//      value's loss (runtime/training/learning/ppo_loss.h), each gradient at most `gradient_max`
//      long; no epoch more once the policy has come twice as far as `kl_target`
//   4. the policy's learning rate becomes 1.5 times as large where the policy has come less than
//   two thirds
//      of kl_target, and as much smaller where it has come farther than 1.5 times that
//   5. the moments of observations take in those of the batch
#pragma once

#include <vector>

#include "runtime/training/learning/ppo_loss.h"
#include "runtime/training/learning/ppo_state.h"
#include "runtime/training/learning/random.h"

namespace runtime {

struct PpoSettings {
  double discount = 0.99;
  double gae_lambda = 0.95;
  double clip = 0.2;
  double entropy_bonus = 0;
  double learning_rate = 3e-4;  // of the policy, in the first update
  double value_learning_rate = 1e-3;
  double kl_target = 0.015;  // 0: the learning rate stays what it is
  double gradient_max = 1;
  int epochs = 5;
  int minibatch = 64;
  // Of actions: learned from `deviation` on, at least `deviation_min`; or brought down from the one
  // to the other over the first `deviation_decisions`, in equal steps.
  double deviation = 0.3;
  double deviation_min = 0.1;
  int64_t deviation_decisions = 400'000;
  bool learns_deviation = false;

  double ScheduledDeviation(int64_t decisions) const;
};

class PpoUpdate {
 public:
  // Learns from the episodes in `state.batch`, at least one decision, and clears it. Returns how
  // often a decision was passed over since what would be learned was not finite.
  int Learn(const PpoSettings& settings, PpoState& state, Random& random);

 private:
  void Prepare(const PpoSettings& settings, PpoState& state);
  void EstimateEpisode(const PpoSettings& settings, const PpoState& state,
                       const DecisionBatch::Episode& episode);
  void NormalizeAdvantages();
  double RunEpoch(const PpoSettings& settings, PpoState& state, Random& random, int& passed_over);
  void Gather(const int* columns, int count);
  void AdaptRate(const PpoSettings& settings, double divergence, PpoState& state);
  void SetDeviations(const PpoSettings& settings, PpoState& state);

  // Of the batch, a column or an element for each of its columns.
  Eigen::MatrixXf observations_;
  Eigen::VectorXf values_;
  Eigen::VectorXf rewards_;
  Eigen::VectorXf advantages_;
  Eigen::VectorXf targets_;
  Eigen::MatrixXf old_means_;
  Eigen::VectorXf old_log_probabilities_;
  Eigen::MatrixXf actions_;
  std::vector<int> columns_;  // of the decisions

  typename Mlp<float>::Pass pass_;
  PolicySamples<float> samples_;
  Eigen::VectorXf sample_targets_;
  PolicyLoss<float> policy_loss_;
  ValueLoss<float> value_loss_;
};

}  // namespace runtime
