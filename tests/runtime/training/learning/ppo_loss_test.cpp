#include "runtime/training/learning/ppo_loss.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/training/learning/finite_difference.h"

namespace runtime {
namespace {

constexpr int kSamples = 40;

// A policy that has come some way from the one that has selected the actions.
class PolicyLossTest : public testing::Test {
 protected:
  PolicyLossTest() {
    policy_.mean.Randomize(1, random_);
    policy_.log_deviations << -0.5, 0.2;
    samples_.observations = RandomMatrix(3, kSamples, random_);
    Mlp<double>::Pass pass;
    samples_.old_means = policy_.mean.Forward(samples_.observations, pass);
    samples_.old_log_deviations = policy_.log_deviations;
    samples_.actions = samples_.old_means + RandomMatrix(2, kSamples, random_);
    samples_.advantages = RandomMatrix(kSamples, 1, random_);
    policy_.LogProbabilities(samples_.old_means, samples_.actions, samples_.old_log_probabilities);
    policy_.mean.weights() += 0.1 * RandomMatrix(policy_.mean.weights().size(), 1, random_);
    policy_.log_deviations += 0.1 * RandomMatrix(2, 1, random_);
  }

  void ExpectDerivativesOfDifferences(const PolicyLoss<double>::Settings& settings) {
    const auto evaluate = [&] { return loss_.Evaluate(policy_, samples_, settings); };
    const Eigen::VectorXd by_weights = DifferenceQuotients(policy_.mean.weights(), evaluate);
    const Eigen::VectorXd by_deviations = DifferenceQuotients(policy_.log_deviations, evaluate);
    evaluate();
    EXPECT_LT((loss_.gradient() - by_weights).lpNorm<Eigen::Infinity>(), 1e-8);
    EXPECT_LT((loss_.deviation_gradient() - by_deviations).lpNorm<Eigen::Infinity>(), 1e-8);
  }

  Random random_{1};
  GaussianPolicy<double> policy_{{3, 5, 2}};
  PolicySamples<double> samples_;
  PolicyLoss<double> loss_;
};

TEST_F(PolicyLossTest, DerivativesAreThoseOfDifferences) {
  ExpectDerivativesOfDifferences({.clip = 1e6, .entropy_bonus = 0});
  ExpectDerivativesOfDifferences({.clip = 0.2, .entropy_bonus = 0});
  ExpectDerivativesOfDifferences({.clip = 0.2, .entropy_bonus = 0.3});
}

TEST_F(PolicyLossTest, WithoutLimitIsTheMeanOfWeightedAdvantages) {
  Mlp<double>::Pass pass;
  Eigen::VectorXd logs;
  policy_.LogProbabilities(policy_.mean.Forward(samples_.observations, pass), samples_.actions,
                           logs);
  const Eigen::ArrayXd ratios = (logs - samples_.old_log_probabilities).array().exp();
  EXPECT_GT(ratios.maxCoeff(), 1.2);  // some would be clipped
  EXPECT_LT(ratios.minCoeff(), 0.8);
  EXPECT_NEAR(loss_.Evaluate(policy_, samples_, {.clip = 1e6, .entropy_bonus = 0}),
              -(ratios * samples_.advantages.array()).mean(), 1e-14);
  const Eigen::ArrayXd clipped = ratios.min(1.2).max(0.8);
  EXPECT_NEAR(
      loss_.Evaluate(policy_, samples_, {.clip = 0.2, .entropy_bonus = 0}),
      -(ratios * samples_.advantages.array()).min(clipped * samples_.advantages.array()).mean(),
      1e-14);
}

TEST_F(PolicyLossTest, ShowsHowFarThePolicyHasCome) {
  loss_.Evaluate(policy_, samples_, {});
  EXPECT_GT(loss_.divergence(), 0.01);
  Mlp<double>::Pass pass;
  samples_.old_means = policy_.mean.Forward(samples_.observations, pass);
  samples_.old_log_deviations = policy_.log_deviations;
  loss_.Evaluate(policy_, samples_, {});
  EXPECT_NEAR(loss_.divergence(), 0, 1e-15);
}

TEST(ValueLoss, DerivativesAreThoseOfDifferences) {
  Random random(2);
  Mlp<double> value({3, 6, 1});
  value.Randomize(1, random);
  const Eigen::MatrixXd observations = RandomMatrix(3, 10, random);
  const Eigen::VectorXd targets = RandomMatrix(10, 1, random);
  ValueLoss<double> loss;
  const auto evaluate = [&] { return loss.Evaluate(value, observations, targets); };
  const Eigen::VectorXd expected = DifferenceQuotients(value.weights(), evaluate);
  const double at = evaluate();
  EXPECT_LT((loss.gradient() - expected).lpNorm<Eigen::Infinity>(), 1e-8);
  Mlp<double>::Pass pass;
  const Eigen::VectorXd errors = value.Forward(observations, pass).transpose() - targets;
  EXPECT_NEAR(at, errors.squaredNorm() / 20, 1e-14);
}

}  // namespace
}  // namespace runtime
