#include "runtime/training/learning/cma_es.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace runtime {
namespace {

using Eigen::VectorXd;
using Function = std::function<double(const VectorXd&)>;

double Sphere(const VectorXd& x) { return x.squaredNorm(); }

double Ellipsoid(const VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    sum += std::pow(1e6, static_cast<double>(i) / static_cast<double>(x.size() - 1)) * x[i] * x[i];
  }
  return sum;
}

double Rosenbrock(const VectorXd& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    sum += 100 * std::pow(x[i] * x[i] - x[i + 1], 2) + std::pow(x[i] - 1, 2);
  }
  return sum;
}

// How many values of the function it takes until one is below 1e-10; the median of five seeds.
int EvaluationsOf(const Function& function, int dimensions, double start, double sigma) {
  std::vector<int> counts;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    CmaEs search(VectorXd::Constant(dimensions, start), sigma,
                 CmaEs::DefaultPopulation(dimensions));
    int& count = counts.emplace_back(0);
    for (double cost = 1; cost > 1e-10 && count < 100'000; ++count) {
      cost = function(search.Ask(random));
      search.Tell(cost);
    }
  }
  std::ranges::sort(counts);
  return counts[2];
}

// pycma prints these of its own default settings: "(5_w,10)-aCMA-ES (mu_w=3.2,w_1=45%)".
TEST(CmaEs, HasThePublishedSettings) {
  struct Published {
    int dimensions, parents, population;
    double mu_eff;
    int best_percent;
  };
  for (const Published& each :
       {Published{2, 3, 6, 2.0, 63}, Published{4, 4, 8, 2.6, 52}, Published{10, 5, 10, 3.2, 45},
        Published{20, 6, 12, 3.7, 40}, Published{40, 7, 15, 4.5, 34}}) {
    ASSERT_EQ(CmaEs::DefaultPopulation(each.dimensions), each.population);
    const CmaEsSettings settings(each.dimensions, each.population);
    EXPECT_EQ(settings.parents, each.parents);
    EXPECT_NEAR(settings.mu_eff, each.mu_eff, 0.05);
    EXPECT_EQ(std::floor(100 * settings.weights[0]), each.best_percent);
    EXPECT_NEAR(settings.weights.head(settings.parents).sum(), 1, 1e-14);
    EXPECT_LE(settings.weights[each.population - 1], 0);
  }
}

// Hansen and others: about 1600 and 3300 values for spheres of 10 and 20 dimensions, some 4500 for
// an ellipsoid, 5500 for Rosenbrock's function, and without negative weights half as many again.
TEST(CmaEs, NeedsAsManyEvaluationsAsPublished) {
  EXPECT_NEAR(EvaluationsOf(Sphere, 10, 3, 2), 1700, 200);
  EXPECT_NEAR(EvaluationsOf(Sphere, 20, 3, 2), 3400, 400);
  EXPECT_NEAR(EvaluationsOf(Ellipsoid, 10, 3, 2), 4400, 600);
  EXPECT_NEAR(EvaluationsOf(Rosenbrock, 10, 0, 0.5), 5400, 1000);
}

// The candidates of a search of `function`, one below the other.
Eigen::MatrixXd CandidatesOf(const Function& function, double start, double sigma = 0.5) {
  Random random(3);
  CmaEs search(VectorXd::Constant(4, start), sigma, 8);
  Eigen::MatrixXd candidates(4, 200);
  for (Eigen::Index i = 0; i < candidates.cols(); ++i) {
    candidates.col(i) = search.Ask(random);
    search.Tell(function(candidates.col(i)));
  }
  return candidates;
}

// Only the order of values counts.
TEST(CmaEs, MonotoneTransformationsChangeNothing) {
  const Eigen::MatrixXd plain = CandidatesOf(Ellipsoid, 1);
  EXPECT_EQ(CandidatesOf([](const VectorXd& x) { return std::log(Ellipsoid(x)) - 7; }, 1), plain);
  EXPECT_NE(CandidatesOf(Sphere, 1), plain);
}

TEST(CmaEs, PlaceAndScaleOfTheProblemDoNotMatter) {
  const Eigen::MatrixXd plain = CandidatesOf(Rosenbrock, 0);
  const VectorXd shift = VectorXd::Constant(4, 16);
  const Eigen::MatrixXd moved =
      CandidatesOf([&](const VectorXd& x) { return Rosenbrock(x - shift); }, 16);
  EXPECT_LT((moved.colwise() - shift - plain).cwiseAbs().maxCoeff(), 1e-9);
  const Eigen::MatrixXd larger =
      CandidatesOf([](const VectorXd& x) { return Rosenbrock(x / 8); }, 0, 4);
  EXPECT_LT((larger / 8 - plain).cwiseAbs().maxCoeff(), 1e-9);
}

// An ellipsoid whose axes are turned takes as long as one along the coordinates.
TEST(CmaEs, RotationsDoNotMatter) {
  const Eigen::MatrixXd turn =
      Eigen::MatrixXd::NullaryExpr(10, 10,
                                   [](Eigen::Index i, Eigen::Index j) {
                                     return std::cos(static_cast<double>(3 * i + 7 * j * j));
                                   })
          .householderQr()
          .householderQ();
  const int plain = EvaluationsOf(Ellipsoid, 10, 1, 1);
  const int turned =
      EvaluationsOf([&](const VectorXd& x) { return Ellipsoid(turn * x); }, 10, 1, 1);
  EXPECT_NEAR(turned, plain, 0.15 * plain);
}

TEST(CmaEs, WhatHasNoValueIsWorseThanAllElse) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto half = [&](const VectorXd& x) { return x[0] < 0 ? none : Sphere(x); };
  EXPECT_LT(EvaluationsOf(half, 4, 1, 0.5), 2000);
}

TEST(CmaEs, GoesOnBitForBitInTheMiddleOfAGeneration) {
  Random random(1);
  CmaEs search(VectorXd::Constant(5, 1), 0.5, 8);
  for (int i = 0; i < 83; ++i) search.Tell(Rosenbrock(search.Ask(random)));
  std::ostringstream saved;
  search.Save(saved);
  std::istringstream stream(saved.str());
  CmaEs restored;
  restored.Load(stream);
  ASSERT_TRUE(stream);
  Random same = random;
  for (int i = 0; i < 100; ++i) {
    const VectorXd candidate = search.Ask(random);
    ASSERT_EQ(restored.Ask(same), candidate);
    search.Tell(Rosenbrock(candidate));
    restored.Tell(Rosenbrock(candidate));
  }
  EXPECT_EQ(restored.generation(), search.generation());
}

TEST(CmaEs, ADamagedStateChangesNothing) {
  CmaEs search(VectorXd::Constant(3, 1), 0.5, 7);
  std::ostringstream saved;
  search.Save(saved);
  const std::string whole = saved.str();
  for (size_t length = 0; length < whole.size(); length += 5) {
    std::istringstream stream(whole.substr(0, length));
    search.Load(stream);
    EXPECT_FALSE(stream);
    EXPECT_EQ(search.mean(), VectorXd::Constant(3, 1));
  }
}

}  // namespace
}  // namespace runtime
