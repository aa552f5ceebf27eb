#include "runtime/training/learning/box_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

namespace runtime {
namespace {

using Eigen::VectorXd;

// Its local minima are near the points with whole coordinates; the least of all is at
// 5.12 place = 1.
double Rastrigin(const VectorXd& place) {
  double sum = 0;
  for (const double each : place) {
    const double x = 5.12 * each - 1;
    sum += x * x + 10 - 10 * std::cos(2 * std::numbers::pi * x);
  }
  return sum;
}

TEST(BoxSearch, FoldsEachNumberIntoTheBox) {
  for (const double inside : {-0.9, -0.3, 0.0, 0.5, 0.9}) {
    EXPECT_EQ(FoldedIntoBox(inside), inside);
    EXPECT_NEAR(FoldedIntoBox(2.2 - inside), inside, 1e-15);  // mirrored at 1.1
    EXPECT_NEAR(FoldedIntoBox(inside - 4.4), inside, 1e-15);  // a period away
  }
  EXPECT_EQ(FoldedIntoBox(1.1), 1);
  EXPECT_EQ(FoldedIntoBox(-1.1), -1);
  EXPECT_NEAR(FoldedIntoBox(1), 0.975, 1e-15);
  double last = FoldedIntoBox(-20.0);
  for (int i = -1999; i <= 2000; ++i) {
    const double place = FoldedIntoBox(0.01 * i);
    EXPECT_LE(std::abs(place), 1);
    EXPECT_LE(std::abs(place - last), 0.01 + 1e-12);  // continuous
    last = place;
  }
}

TEST(BoxSearch, UnfoldsWhatItFolds) {
  for (int i = -100; i <= 100; ++i) {
    EXPECT_NEAR(FoldedIntoBox(UnfoldedFromBox(0.01 * i)), 0.01 * i, 1e-14);
  }
  EXPECT_NEAR(UnfoldedFromBox(3), 1.1, 1e-15);  // from outside: to the bound
}

TEST(BoxSearch, BeginsAroundItsStart) {
  const BoxSearch search(VectorXd::Constant(3, 0.95), {.sigma = 0.1});
  EXPECT_LT((search.middle() - VectorXd::Constant(3, 0.95)).norm(), 1e-14);
  EXPECT_EQ(search.population(), CmaEs::DefaultPopulation(3));
}

TEST(BoxSearch, FindsAMinimumOnTheBorder) {
  const BoxSearch::Settings settings;
  BoxSearch search(VectorXd::Zero(4), settings);
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const VectorXd& place = search.Ask(settings, random);
    ASSERT_LE(place.cwiseAbs().maxCoeff(), 1);
    search.Tell(place.sum());
  }
  EXPECT_LT((search.middle() + VectorXd::Ones(4)).norm(), 1e-6);
}

// Auger and Hansen (2005) report some 10^4 to 10^5 values, with a few restarts.
TEST(BoxSearch, RestartsWithMoreCandidatesUntilItFindsTheLeastOfManyMinima) {
  const BoxSearch::Settings settings{.sigma = 0.4};
  Random random(1);
  BoxSearch search(VectorXd::Zero(5), settings);
  double best = 1;
  int count = 0;
  while (best > 1e-10 && count < 100'000) {
    const double cost = Rastrigin(search.Ask(settings, random));
    best = std::min(best, cost);
    search.Tell(cost);
    ++count;
  }
  EXPECT_LT(count, 50'000);
  EXPECT_GE(search.restarts(), 1);
  EXPECT_EQ(search.population(), 8 << search.restarts());
}

TEST(BoxSearch, StartsElsewhereWhereCandidatesHardlyDiffer) {
  const BoxSearch::Settings settings{.sigma = 0.3, .growth = 1, .least_step = 0.01};
  Random random(1);
  BoxSearch search(VectorXd::Zero(2), settings);
  int64_t generation = 0;
  for (int i = 0; search.restarts() < 2 && i < 5000; ++i) {
    search.Tell(search.Ask(settings, random).squaredNorm());
    EXPECT_GE(search.generation(), generation);
    generation = search.generation();
  }
  EXPECT_EQ(search.restarts(), 2);
  EXPECT_EQ(search.population(), CmaEs::DefaultPopulation(2));
}

// Equal costs wherever one looks.
TEST(BoxSearch, StartsElsewhereWhereNothingCountsAnything) {
  const BoxSearch::Settings settings;
  Random random(1);
  BoxSearch search(VectorXd::Zero(2), settings);
  for (int i = 0; i < 500; ++i) {
    search.Ask(settings, random);
    search.Tell(7);
  }
  EXPECT_GT(search.restarts(), 0);
}

TEST(BoxSearch, GoesOnBitForBit) {
  const BoxSearch::Settings settings{.sigma = 0.4, .least_step = 0.01};
  Random random(1);
  BoxSearch search(VectorXd::Zero(3), settings);
  while (search.restarts() < 1) search.Tell(Rastrigin(search.Ask(settings, random)));
  std::ostringstream saved;
  search.Save(saved);
  std::istringstream stream(saved.str());
  BoxSearch restored;
  restored.Load(stream);
  ASSERT_TRUE(stream);
  EXPECT_EQ(restored.middle(), search.middle());
  Random same = random;
  while (search.restarts() < 3) {
    const VectorXd place = search.Ask(settings, random);
    ASSERT_EQ(restored.Ask(settings, same), place);
    search.Tell(Rastrigin(place));
    restored.Tell(Rastrigin(place));
  }
  EXPECT_EQ(restored.restarts(), search.restarts());
  EXPECT_EQ(restored.generation(), search.generation());
}

}  // namespace
}  // namespace runtime
