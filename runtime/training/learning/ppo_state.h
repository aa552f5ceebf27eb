// What PPO has learned and counted: all that acting and learning go on from.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <vector>

#include "runtime/training/learning/adam.h"
#include "runtime/training/learning/decision_batch.h"
#include "runtime/training/learning/gaussian_policy.h"
#include "runtime/training/learning/policy_graph.h"
#include "runtime/training/learning/running_moments.h"

namespace runtime {

// What the last update was like; not a number before the first one.
struct PpoFigures {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double entropy = kNone;
  double divergence = kNone;
  double policy_loss = kNone;
  double value_loss = kNone;
  double explained_variance = kNone;
  double deviation = kNone;
  double learning_rate = kNone;
};

struct PpoState {
  PpoState() = default;
  // `hidden`: sizes of the hidden layers of both networks. The weights are random, the deviations
  // of actions all the same.
  PpoState(int observation_size, int action_size, const std::vector<int>& hidden, double deviation,
           Random& random);

  int observation_size() const { return policy.mean.inputs(); }
  int action_size() const { return policy.mean.outputs(); }

  // An observation, or each of many, as the networks get it: measured by the moments of all that
  // were learned from, and at most 10 in size.
  void Normalize(Eigen::Ref<Eigen::MatrixXf> observations) const;

  // The same, and then the mean of the policy: from an observation to an action.
  PolicyGraph::Value AddPolicy(PolicyGraph& graph, PolicyGraph::Value observation) const;

  // As before the first update, by themselves: the estimate of what observations are worth, with
  // its optimizer; how large rewards are; the optimizers, with the learning rate.
  void ForgetValue(Random& random);
  void ForgetScale();
  void ForgetOptimizers();

  // From now on the same actions come of the same observations as with `other`, and the batch, of
  // the same sizes as the other one, is empty.
  void ActLike(const PpoState& other);

  void Save(std::ostream& out) const;
  // Throws nothing: the stream has failed where it holds something else.
  static PpoState Load(std::istream& in);

  GaussianPolicy<float> policy;
  Mlp<float> value;  // of an observation, in units of the deviation of discounted returns
  Adam<float> mean_optimizer;
  Adam<float> deviation_optimizer;
  Adam<float> value_optimizer;
  RunningMoments observations;
  RunningMoments returns;  // discounted sums of the rewards of an episode so far
  double rate_factor = 1;  // of the learning rate
  int64_t decisions = 0;   // that were learned from
  PpoFigures figures;
  DecisionBatch batch;  // not learned from yet

 private:
  PpoState(const std::vector<int>& policy_sizes, const std::vector<int>& value_sizes);
};

}  // namespace runtime
