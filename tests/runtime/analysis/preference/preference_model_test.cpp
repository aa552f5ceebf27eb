#include "runtime/analysis/preference/preference_model.h"

#include <gmock/gmock.h>

#include <cmath>

namespace runtime {
namespace {

// Two terms, of which the second has a weight.
PreferenceModel OneWeight() {
  PreferenceModel model;
  model.loads = Eigen::Vector2d(0, 1);
  model.scale = 2;
  model.prior_sd = 2;
  model.comparisons = {{Eigen::Vector2d(3, -2), 1}};
  return model;
}

// Four terms: one without a weight, one with two weights.
PreferenceModel ThreeWeights() {
  PreferenceModel model;
  model.loads = Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}};
  model.scale = 1.7;
  model.prior_sd = 0.7;
  model.comparisons = {{Eigen::Vector4d(3, -2, 0.4, 1), 1},
                       {Eigen::Vector4d(-5, 1, -0.3, 2), 0.5},
                       {Eigen::Vector4d(0.1, 0, -2, -1), 1}};
  return model;
}

Eigen::VectorXd Ln2() { return Eigen::VectorXd::Constant(1, std::log(2)); }

TEST(PreferenceModel, AWeightScalesItsTermAlone) {
  EXPECT_TRUE(TermFactors(OneWeight().loads, Ln2()).isApprox(Eigen::Vector2d(1, 2)));
}

// A weight twice as large: 3 - 2 * 2 = -1, which is half a scale.
TEST(PreferenceModel, AdvantageIsTheDifferenceOfReturnsInScales) {
  Eigen::VectorXd gradient;
  const PreferenceModel model = OneWeight();
  const Eigen::VectorXd& difference = model.comparisons[0].difference;
  EXPECT_DOUBLE_EQ(Advantage(model, difference, Ln2(), &gradient), -0.5);
  EXPECT_DOUBLE_EQ(gradient[0], -2);
  EXPECT_DOUBLE_EQ(Advantage(model, difference, Eigen::VectorXd::Zero(1)), 0.5);
}

TEST(PreferenceModel, TheHigherReturnIsPreferredByTheLogisticFunction) {
  EXPECT_DOUBLE_EQ(Logistic(0), 0.5);
  EXPECT_DOUBLE_EQ(Logistic(std::log(3)), 0.75);
  EXPECT_DOUBLE_EQ(Logistic(1000), 1);
  EXPECT_DOUBLE_EQ(Logistic(-1000), 0);
}

TEST(PreferenceModel, EquallyGoodAreReturnsWithinAScale) {
  EXPECT_TRUE(Holds({{}, 1}, 0.1));
  EXPECT_FALSE(Holds({{}, 1}, -0.1));
  EXPECT_TRUE(Holds({{}, 0.5}, -0.9));
  EXPECT_FALSE(Holds({{}, 0.5}, 1.1));
}

TEST(PreferenceModel, PosteriorIsThatOfBradleyAndTerryWithAGaussianPrior) {
  PreferenceModel model = OneWeight();
  const double prior = 0.5 * std::pow(std::log(2) / 2, 2);
  EXPECT_DOUBLE_EQ(NegativeLogPosterior(model, Ln2()), prior - std::log(1 / (1 + std::exp(0.5))));
  model.comparisons[0].outcome = 0.5;  // half a victory, half a defeat
  EXPECT_DOUBLE_EQ(
      NegativeLogPosterior(model, Ln2()),
      prior - 0.5 * (std::log(1 / (1 + std::exp(0.5))) + std::log(1 / (1 + std::exp(-0.5)))));
}

TEST(PreferenceModel, IsFiniteWhereTheProbabilityIsNone) {
  PreferenceModel model = OneWeight();
  model.comparisons[0].difference = Eigen::Vector2d(-4000, 0);
  EXPECT_DOUBLE_EQ(NegativeLogPosterior(model, Eigen::VectorXd::Zero(1)), 2000);
}

TEST(PreferenceModel, GradientIsThatOfFiniteDifferences) {
  const PreferenceModel model = ThreeWeights();
  const Eigen::Vector3d x(0.3, -0.5, 0.8);
  Eigen::VectorXd gradient;
  NegativeLogPosterior(model, x, &gradient);
  constexpr double kStep = 1e-5;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const double slope =
        (NegativeLogPosterior(model, x + step) - NegativeLogPosterior(model, x - step)) /
        (2 * kStep);
    EXPECT_NEAR(gradient[i], slope, 1e-8) << i;
  }
}

// The mean over the outcomes that the model itself expects: by finite differences of the gradient.
TEST(PreferenceModel, InformationIsTheExpectedHessian) {
  PreferenceModel model = ThreeWeights();
  const Eigen::Vector3d x(0.3, -0.5, 0.8);
  for (Comparison& comparison : model.comparisons) {
    comparison.outcome = Logistic(Advantage(model, comparison.difference, x));
  }
  const Eigen::MatrixXd information = Information(model, x);
  constexpr double kStep = 1e-5;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    Eigen::VectorXd above, below;
    NegativeLogPosterior(model, x + step, &above);
    NegativeLogPosterior(model, x - step, &below);
    EXPECT_TRUE(information.col(i).isApprox((above - below) / (2 * kStep), 1e-7)) << i;
  }
}

}  // namespace
}  // namespace runtime
