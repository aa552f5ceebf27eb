#include "runtime/trainer/rescore/rank_correlation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace runtime {
namespace {

using testing::ElementsAre;

TEST(RankCorrelation, RanksTheGreatestFirstAndEqualOnesTogether) {
  EXPECT_THAT(RanksOf({3, 1, 2}), ElementsAre(1, 3, 2));
  EXPECT_THAT(RanksOf({3, 1, 3, 0}), ElementsAre(1.5, 3, 1.5, 4));
}

TEST(RankCorrelation, IsOneForTheSameOrderAndMinusOneForItsReverse) {
  const RankCorrelation same = RankCorrelationOf({1, 2, 3, 4}, {10, 20, 21, 1000});
  EXPECT_DOUBLE_EQ(same.spearman, 1);
  EXPECT_DOUBLE_EQ(same.kendall, 1);
  const RankCorrelation reverse = RankCorrelationOf({1, 2, 3, 4}, {4, 3, 2, 1});
  EXPECT_DOUBLE_EQ(reverse.spearman, -1);
  EXPECT_DOUBLE_EQ(reverse.kendall, -1);
}

// By hand: rho = 1 - 6 * (1 + 1 + 1 + 1) / (4 * 15) = 0.6; of six pairs two disagree: 2 / 6.
TEST(RankCorrelation, IsAsPublished) {
  const RankCorrelation order = RankCorrelationOf({1, 2, 3, 4}, {2, 1, 4, 3});
  EXPECT_DOUBLE_EQ(order.spearman, 0.6);
  EXPECT_DOUBLE_EQ(order.kendall, 1.0 / 3);
}

// tau-b: one pair is equal in the second, so (3 - 2) / ... of pairs (1,2) (1,3) (2,3): all agree
// but for the equal one: 2 / sqrt(3 * 2).
TEST(RankCorrelation, CountsEqualScoresAsTauBDoes) {
  EXPECT_DOUBLE_EQ(RankCorrelationOf({1, 2, 3}, {1, 2, 2}).kendall, 2 / std::sqrt(6));
}

TEST(RankCorrelation, IsNoNumberWhereThereIsNoOrder) {
  EXPECT_TRUE(std::isnan(RankCorrelationOf({}, {}).spearman));
  EXPECT_TRUE(std::isnan(RankCorrelationOf({1}, {2}).kendall));
  EXPECT_TRUE(std::isnan(RankCorrelationOf({1, 1}, {1, 2}).spearman));
}

}  // namespace
}  // namespace runtime
