#include "runtime/training/learning/boltzmann.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/training/learning/random.h"

namespace runtime {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd Probabilities(const VectorXd& values, double temperature) {
  VectorXd probabilities(values.size());
  BoltzmannProbabilities(values, temperature, probabilities);
  return probabilities;
}

// exp(-3/2) : exp(-1) : 1, over their sum 1.5910096013.
TEST(Boltzmann, GivesTheProbabilitiesOfTheFormula) {
  const VectorXd probabilities = Probabilities(Vector3d(1, 2, 4), 2);
  EXPECT_NEAR(probabilities[0], 0.14024438316608848, 1e-15);
  EXPECT_NEAR(probabilities[1], 0.23122389762214907, 1e-15);
  EXPECT_NEAR(probabilities[2], 0.6285317192117624, 1e-15);
}

TEST(Boltzmann, OnlyDifferencesOfValuesMatter) {
  const VectorXd low = Probabilities(Vector3d(1, 2, 4), 2);
  const VectorXd high = Probabilities(Vector3d(1e6 + 1, 1e6 + 2, 1e6 + 4), 2);
  EXPECT_EQ(low, high);
}

TEST(Boltzmann, IsGreedyWithoutTemperature) {
  const VectorXd probabilities = Probabilities(Vector3d(1, 1 + 1e-9, -5), 1e-300);
  EXPECT_LT(probabilities[0], 1e-300);
  EXPECT_EQ(probabilities[1], 1);
  EXPECT_LT(probabilities[2], 1e-300);
}

TEST(Boltzmann, SharesTheProbabilityBetweenEqualValues) {
  const VectorXd probabilities = Probabilities(Vector3d(2, -1e300, 2), 1e-300);
  EXPECT_EQ(probabilities[0], 0.5);
  EXPECT_EQ(probabilities[2], 0.5);
}

TEST(Boltzmann, IsUniformWhereThereIsNoSum) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const VectorXd probabilities = Probabilities(Vector3d(nan, nan, nan), 1);
  EXPECT_EQ(probabilities, Vector3d::Constant(1.0 / 3));
}

TEST(Roulette, FindsTheActionInWhoseShareTheNumberLies) {
  const VectorXd probabilities = Vector3d(0.25, 0.5, 0.25);
  EXPECT_EQ(SampleCategorical(probabilities, 0), 0);
  EXPECT_EQ(SampleCategorical(probabilities, std::nextafter(0.25, 0)), 0);
  EXPECT_EQ(SampleCategorical(probabilities, 0.25), 1);
  EXPECT_EQ(SampleCategorical(probabilities, std::nextafter(0.75, 0)), 1);
  EXPECT_EQ(SampleCategorical(probabilities, 0.75), 2);
  EXPECT_EQ(SampleCategorical(probabilities, std::nextafter(1.0, 0)), 2);
}

TEST(Roulette, NeverChoosesAnActionWithoutProbability) {
  EXPECT_EQ(SampleCategorical(Vector3d(0, 1, 0), 0), 1);
  EXPECT_EQ(SampleCategorical(Vector3d(0, 1 - 1e-15, 0), std::nextafter(1.0, 0)), 1);
}

TEST(Roulette, ChoosesAsOftenAsTheProbabilitiesSay) {
  Random random(5);
  const VectorXd probabilities = Vector3d(0.1, 0.6, 0.3);
  VectorXd counts = Vector3d::Zero();
  for (int i = 0; i < 10000; ++i) counts[SampleCategorical(probabilities, random.Uniform())] += 1;
  EXPECT_LT((counts / 10000 - probabilities).cwiseAbs().maxCoeff(), 0.015);
}

}  // namespace
}  // namespace runtime
