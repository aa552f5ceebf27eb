#include "runtime/analysis/behavior/clustering.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Between places on a line.
Eigen::MatrixXd Distances(const std::vector<double>& places) {
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd distances(count, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      distances(a, b) = std::abs(places[static_cast<size_t>(a)] - places[static_cast<size_t>(b)]);
    }
  }
  return distances;
}

TEST(Cluster, JoinsWhatIsNear) {
  EXPECT_THAT(Cluster(Distances({0, 10, 1, 11, 12}), 5),
              ElementsAre(ElementsAre(1, 3, 4), ElementsAre(0, 2)));
}

TEST(Cluster, ListsEqualGroupsInTheOrderOfTheirFirstMembers) {
  EXPECT_THAT(Cluster(Distances({50, 0, 51, 1}), 5),
              ElementsAre(ElementsAre(0, 2), ElementsAre(1, 3)));
}

// 0 and 2 are joined first; 5 is then 5 and 3 apart from them, 4 on average.
TEST(Cluster, TakesTheMeanOverAllPairs) {
  const Eigen::MatrixXd distances = Distances({0, 2, 5});
  EXPECT_THAT(Cluster(distances, 3.99), ElementsAre(ElementsAre(0, 1), ElementsAre(2)));
  EXPECT_THAT(Cluster(distances, 4.01), ElementsAre(ElementsAre(0, 1, 2)));
}

// {0, 1, 2} by {3.5}: (3.5 + 2.5 + 1.5) / 3 = 2.5, not the mean of two means, which is 2.25
// or 2.75.
TEST(Cluster, WeighsGroupsByTheirSizes) {
  const Eigen::MatrixXd distances = Distances({0, 1, 2, 3.5});
  EXPECT_EQ(Cluster(distances, 2.49).size(), 2u);
  EXPECT_EQ(Cluster(distances, 2.51).size(), 1u);
}

TEST(Cluster, LeavesAloneWhatIsAsFarAsTheThreshold) {
  EXPECT_EQ(Cluster(Distances({0, 1}), 1).size(), 2u);
}

TEST(Cluster, KnowsFewAndStrangeThings) {
  EXPECT_THAT(Cluster(Distances({}), 1), IsEmpty());
  EXPECT_THAT(Cluster(Distances({3}), 1), ElementsAre(ElementsAre(0)));
  EXPECT_EQ(Cluster(Distances({0, std::numeric_limits<double>::quiet_NaN(), 0.5}), 1).size(), 2u);
}

TEST(GroupAlike, ClustersFewAndNamesTheMostTypical) {
  const Eigen::MatrixXd distances = Distances({0, 10, 1, 11, 12});
  const auto groups = GroupAlike(
      5, [&](int a, int b) { return distances(a, b); }, 5);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_THAT(groups[0].members, ElementsAre(1, 3, 4));
  EXPECT_EQ(groups[0].typical, 3);
  EXPECT_THAT(groups[1].members, ElementsAre(0, 2));
}

// Of which the two of the last group are no part of those that are clustered first.
TEST(GroupAlike, OfManyFindsWhatIsRareAsWell) {
  constexpr int kCount = 5 * kMostClustered;
  const auto kind = [](int thing) { return thing == 7 || thing == 8 ? 2 : thing % 2; };
  const auto groups = GroupAlike(
      kCount, [&](int a, int b) { return kind(a) == kind(b) ? 0.5 : 3; }, 2);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].members.size(), kCount / 2 - 1);
  EXPECT_EQ(groups[1].members.size(), kCount / 2 - 1);
  EXPECT_THAT(groups[2].members, ElementsAre(7, 8));
  for (const AlikeGroup& group : groups) {
    for (const int member : group.members) EXPECT_EQ(kind(member), kind(group.typical));
  }
}

TEST(GroupAlike, AsksSeveralMembersAndTakesTheNearestGroup) {
  constexpr int kCount = 3 * kMostClustered;
  // Two heaps, each a unit wide, with three between them.
  const auto place = [](int thing) { return thing % 2 * 4 + 0.001 * (thing % 1000); };
  const auto groups = GroupAlike(
      kCount, [&](int a, int b) { return std::abs(place(a) - place(b)); }, 2);
  ASSERT_EQ(groups.size(), 2u);
  for (const AlikeGroup& group : groups) {
    for (const int member : group.members) EXPECT_EQ(member % 2, group.typical % 2);
  }
}

TEST(MostTypical, IsInTheMiddle) {
  const Eigen::MatrixXd distances = Distances({0, 4, 5, 100, 9});
  EXPECT_EQ(MostTypical(distances, {0, 1, 2, 4}), 1);  // 4 + 1 + 5, as far as 2 is: 5 + 1 + 4
  EXPECT_EQ(MostTypical(distances, {3}), 3);
}

}  // namespace
}  // namespace runtime
