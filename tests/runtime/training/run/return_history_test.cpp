#include "runtime/training/run/return_history.h"

#include <gmock/gmock.h>

#include <limits>

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ReturnHistory, ShowsEachEpisodeWhileThereIsRoom) {
  ReturnHistory history;
  EXPECT_THAT(history.Means(10), IsEmpty());
  for (const double each : {3, 1, 2}) history.Add(each);
  EXPECT_THAT(history.Means(10), ElementsAre(3, 1, 2));
  EXPECT_THAT(history.Means(3), ElementsAre(3, 1, 2));
  EXPECT_THAT(history.Means(2), ElementsAre(2, 2));
  EXPECT_THAT(history.Means(1), ElementsAre(2));
}

TEST(ReturnHistory, LeavesOutWhatIsNotFinite) {
  ReturnHistory history;
  history.Add(std::numeric_limits<double>::quiet_NaN());
  history.Add(1);
  history.Add(-std::numeric_limits<double>::infinity());
  EXPECT_THAT(history.Means(5), ElementsAre(1));
}

TEST(ReturnHistory, KeepsTheWholeRunInAFewMeans) {
  ReturnHistory history;
  constexpr int kEpisodes = 8 * static_cast<int>(ReturnHistory::kMost);
  for (int i = 0; i < kEpisodes; ++i) history.Add(i);
  EXPECT_EQ(history.Means(100'000).size(), ReturnHistory::kMost);
  EXPECT_THAT(history.Means(2), ElementsAre(kEpisodes / 4. - 0.5, 3 * kEpisodes / 4. - 0.5));
  history.Add(0);  // one more than fits
  EXPECT_EQ(history.Means(100'000).size(), ReturnHistory::kMost / 2 + 1);
  EXPECT_EQ(history.Means(100'000).back(), 0);
}

}  // namespace
}  // namespace runtime
