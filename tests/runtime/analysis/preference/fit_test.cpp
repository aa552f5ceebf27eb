#include "runtime/analysis/preference/fit.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace runtime {
namespace {

constexpr double kLn1000 = 6.907755278982137;

// `weights` terms with a weight each, behind one without.
PreferenceModel Model(Eigen::Index weights) {
  PreferenceModel model;
  model.loads = Eigen::MatrixXd::Zero(weights + 1, weights);
  model.loads.bottomRows(weights).setIdentity();
  model.prior_sd = std::log(2);
  model.lower = Eigen::VectorXd::Constant(weights, -kLn1000);
  model.upper = Eigen::VectorXd::Constant(weights, kLn1000);
  return model;
}

double OnGrid(const PreferenceModel& model, double from, double to) {
  constexpr int kPoints = 200'001;
  double best = from;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPoints; ++i) {
    const double x = from + (to - from) * i / (kPoints - 1);
    const double value = NegativeLogPosterior(model, Eigen::VectorXd::Constant(1, x));
    if (value < least) {
      least = value;
      best = x;
    }
  }
  return best;
}

TEST(FitWeights, OfOneWeightIsTheBestOnAGrid) {
  PreferenceModel model = Model(1);
  model.comparisons = {{Eigen::Vector2d(-3, 1), 1}, {Eigen::Vector2d(1, -0.5), 0.5}};
  const Fit fit = FitWeights(model);
  EXPECT_NEAR(fit.x[0], OnGrid(model, -2, 2), 2e-5);
  EXPECT_GT(fit.x[0], 0.1);
}

// By hand: where x = 0 the slope is p - 1 = -1/2 of the comparison's, 4, so that the weight grows.
// It comes to rest where x / sd^2 = 4 exp(x) (1 - p), p = logistic(4 exp(x) - 4).
TEST(FitWeights, ComesToRestWhereComparisonsAndPriorBalance) {
  PreferenceModel model = Model(1);
  model.comparisons = {{Eigen::Vector2d(-4, 4), 1}};
  const double x = FitWeights(model).x[0];
  const double p = 1 / (1 + std::exp(4 - 4 * std::exp(x)));
  EXPECT_NEAR(x / (std::log(2) * std::log(2)), 4 * std::exp(x) * (1 - p), 1e-6);
}

TEST(FitWeights, AWeightOfWhichNothingIsKnownStaysAsItIs) {
  PreferenceModel model = Model(2);
  model.comparisons = {{Eigen::Vector3d(-3, 1, 0), 1}};
  const Fit fit = FitWeights(model);
  EXPECT_GT(fit.x[0], 0.1);
  EXPECT_EQ(fit.x[1], 0);
  EXPECT_DOUBLE_EQ(fit.covariance(1, 1), model.prior_sd * model.prior_sd);
  EXPECT_LT(fit.covariance(0, 0), model.prior_sd * model.prior_sd);
}

TEST(FitWeights, RangesAreBounds) {
  PreferenceModel model = Model(1);
  model.upper[0] = 0.05;
  model.comparisons = {{Eigen::Vector2d(-3, 1), 1}};
  EXPECT_DOUBLE_EQ(FitWeights(model).x[0], 0.05);
  model.comparisons = {{Eigen::Vector2d(3, -1), 1}};
  model.lower[0] = 0;
  model.upper[0] = 0;
  EXPECT_DOUBLE_EQ(FitWeights(model).x[0], 0);
}

TEST(FitWeights, MorePreferencesChangeMore) {
  PreferenceModel model = Model(1);
  double before = 0;
  for (int count = 1; count <= 4; ++count) {
    model.comparisons.push_back({Eigen::Vector2d(-3, 1), 1});
    const double x = FitWeights(model).x[0];
    EXPECT_GT(x, before);
    before = x;
  }
  EXPECT_LT(before, std::log(5));
}

// The weight must grow forty times, and until then hardly anything becomes better.
TEST(FitWeights, FindsTheFartherOfTwoMinimaWhereItIsBetter) {
  PreferenceModel model = Model(1);
  model.prior_sd = 1.5;
  model.comparisons.assign(10, {Eigen::Vector2d(-2, 0.05), 1});
  EXPECT_GT(FitWeights(model).x[0], std::log(40));
  EXPECT_NEAR(FitWeights(model).x[0], OnGrid(model, -kLn1000, kLn1000), 1e-4);
}

// Preferences of someone whose weights are known, drawn from the model.
TEST(FitWeights, FindsTheWeightsBehindManyPreferences) {
  PreferenceModel model = Model(2);
  const Eigen::Vector2d truth(0.7, -0.4);
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 3);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 3000; ++i) {
    Eigen::VectorXd difference = Eigen::Vector3d::NullaryExpr([&] { return normal(random); });
    if (uniform(random) > Logistic(Advantage(model, difference, truth))) difference *= -1;
    model.comparisons.push_back({difference, 1});
  }
  const Fit fit = FitWeights(model);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double sd = std::sqrt(fit.covariance(i, i));
    EXPECT_LT(sd, 0.05);
    EXPECT_NEAR(fit.x[i], truth[i], 3 * sd);
  }
}

TEST(FitWeights, SaysTheSameTwice) {
  PreferenceModel model = Model(2);
  model.comparisons = {{Eigen::Vector3d(-3, 1, 2), 1}, {Eigen::Vector3d(2, 1, -3), 1}};
  EXPECT_EQ(FitWeights(model).x, FitWeights(model).x);
}

// The weight must lie between 100 and 101 times what it was.
TEST(HoldAtBest, IsTrueHoweverNarrowTheRange) {
  PreferenceModel model = Model(1);
  model.comparisons = {{Eigen::Vector2d(-1, 0.01), 1}, {Eigen::Vector2d(1.01, -0.01), 1}};
  EXPECT_THAT(HoldAtBest(model), testing::ElementsAre(true, true));
}

TEST(HoldAtBest, IsFalseOfWhatNoWeightCanExplain) {
  PreferenceModel model = Model(1);
  model.comparisons = {{Eigen::Vector2d(-1, -0.5), 1}, {Eigen::Vector2d(-5, 1), 1}};
  EXPECT_THAT(HoldAtBest(model), testing::ElementsAre(false, true));
  model.upper[0] = std::log(4);  // where 5 were needed
  EXPECT_THAT(HoldAtBest(model), testing::ElementsAre(false, false));
}

// By chance whether there are weights or not; what is found is as good as a search over all.
TEST(HoldAtBest, IsTrueOfAllWhereverAnyWeightsExplainAll) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  int explained = 0;
  for (int trial = 0; trial < 100; ++trial) {
    PreferenceModel model = Model(2);
    model.lower.setConstant(-3);
    model.upper.setConstant(3);
    for (int i = 0; i < 5; ++i) {
      model.comparisons.push_back(
          {Eigen::Vector3d::NullaryExpr([&] { return normal(random); }), 1});
    }
    const auto least = [&](const Eigen::VectorXd& x) {
      double advantage = std::numeric_limits<double>::infinity();
      for (const Comparison& each : model.comparisons) {
        advantage = std::min(advantage, Advantage(model, each.difference, x));
      }
      return advantage;
    };
    double best = -1;
    for (double a = -3; a <= 3; a += 0.05) {
      for (double b = -3; b <= 3; b += 0.05) best = std::max(best, least(Eigen::Vector2d(a, b)));
    }
    const bool is_explained = best > 0.01;
    const bool is_inexplicable = best < -0.2;  // the grid is not everywhere
    explained += is_explained;
    if (is_inexplicable) {
      EXPECT_THAT(HoldAtBest(model), testing::Contains(false)) << trial;
    }
    if (!is_explained) continue;
    EXPECT_THAT(HoldAtBest(model), testing::Each(true)) << trial;
  }
  EXPECT_GT(explained, 10);
  EXPECT_LT(explained, 90);
}

TEST(ExpectedInformation, IsGreatestWhereTheAnswerIsOpenAndWeightsDecideIt) {
  const PreferenceModel model = Model(1);
  const Fit fit = FitWeights(model);  // of no preference at all: the prior
  // p = 1/2, and the advantage has the slope 2: log(1 + 4 sd^2 / 4) / 2.
  EXPECT_DOUBLE_EQ(ExpectedInformation(model, fit, Eigen::Vector2d(-2, 2)),
                   0.5 * std::log1p(std::log(2) * std::log(2)));
  EXPECT_EQ(ExpectedInformation(model, fit, Eigen::Vector2d(1, 0)), 0);
  EXPECT_LT(ExpectedInformation(model, fit, Eigen::Vector2d(5, 2)),
            ExpectedInformation(model, fit, Eigen::Vector2d(0, 2)));
}

}  // namespace
}  // namespace runtime
