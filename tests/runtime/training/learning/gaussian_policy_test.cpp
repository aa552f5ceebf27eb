#include "runtime/training/learning/gaussian_policy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace runtime {
namespace {

const double kLogRoot = std::log(std::sqrt(2 * std::numbers::pi));

class GaussianPolicyTest : public testing::Test {
 protected:
  GaussianPolicyTest() { policy_.log_deviations << std::log(0.5), std::log(2.0); }

  GaussianPolicy<double> policy_{{1, 2}};
};

// Of a normal number x: -(x - mean)^2 / (2 s^2) - log s - log sqrt(2 pi).
TEST_F(GaussianPolicyTest, LogProbabilityIsTheSumOverTheElements) {
  Eigen::VectorXd logs;
  policy_.LogProbabilities(Eigen::Vector2d(1, 0), Eigen::Vector2d(1.5, -2), logs);
  ASSERT_EQ(logs.size(), 1);
  EXPECT_NEAR(logs[0], -0.5 - 0.5 - std::log(0.5) - std::log(2.0) - 2 * kLogRoot, 1e-14);
}

// Of a normal number: 1/2 + log s + log sqrt(2 pi).
TEST_F(GaussianPolicyTest, EntropyGrowsWithTheDeviations) {
  EXPECT_NEAR(policy_.Entropy(), 1 + 2 * kLogRoot, 1e-14);
  policy_.log_deviations[0] += 0.3;
  EXPECT_NEAR(policy_.Entropy(), 1.3 + 2 * kLogRoot, 1e-14);
}

TEST_F(GaussianPolicyTest, DivergenceIsThatOfNormalNumbers) {
  const Eigen::MatrixXd means{{1, 2}, {3, 4}};
  EXPECT_NEAR(policy_.DivergenceFrom(means, policy_.log_deviations, means), 0, 1e-15);
  // One of two samples is 0.5 away, in units of the deviation 1: its share is 1/2 * 1/2.
  const Eigen::MatrixXd moved{{1, 2.5}, {3, 4}};
  EXPECT_NEAR(policy_.DivergenceFrom(moved, policy_.log_deviations, means), 0.25, 1e-14);
  // KL(N(0, 1) || N(0, s)) = log s + 1 / (2 s^2) - 1/2, for s = 0.5 and 2.
  EXPECT_NEAR(policy_.DivergenceFrom(means, Eigen::Vector2d::Zero(), means),
              std::log(0.5) + 2 - 0.5 + std::log(2.0) + 0.125 - 0.5, 1e-14);
}

}  // namespace
}  // namespace runtime
