#include "runtime/analysis/report/choose_recordings.h"

#include <gmock/gmock.h>

#include <limits>

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr size_t kPlenty = 1 << 20;

// Episodes 10, 20, ... with these returns, 100 bytes each.
std::vector<RecordingEntry> Entries(const std::vector<double>& returns) {
  std::vector<RecordingEntry> entries;
  for (const double value : returns) {
    entries.push_back({10 * static_cast<int64_t>(entries.size() + 1), value, 100});
  }
  return entries;
}

TEST(ChooseRecordings, TakesAllWhereThereIsRoom) {
  EXPECT_THAT(ChooseRecordings(Entries({1, 3, 2}), kPlenty, 10), ElementsAre(0, 1, 2));
  EXPECT_THAT(ChooseRecordings({}, kPlenty, 10), IsEmpty());
}

TEST(ChooseRecordings, TakesTheBestWhateverItsSize) {
  EXPECT_THAT(ChooseRecordings(Entries({1, 3, 2}), 0, 1), ElementsAre(1));
}

TEST(ChooseRecordings, ThenTheLastAndTheFirst) {
  const auto entries = Entries({1, 2, 9, 4, 5});
  EXPECT_THAT(ChooseRecordings(entries, 200, 10), ElementsAre(2, 4));
  EXPECT_THAT(ChooseRecordings(entries, 300, 10), ElementsAre(0, 2, 4));
}

TEST(ChooseRecordings, SpreadsTheOthersOverTheRun) {
  // Chosen: 0, 1 and 8; the episode farthest from these is that of index 4 (30 from 1, 40 from 8).
  const auto entries = Entries({1, 9, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_THAT(ChooseRecordings(entries, kPlenty, 4), ElementsAre(0, 1, 4, 8));
}

TEST(ChooseRecordings, NeverExceedsTheBudget) {
  EXPECT_THAT(ChooseRecordings(Entries({1, 9, 0, 0, 0}), 399, 10), testing::SizeIs(3));
}

TEST(BestRecording, IsTheFirstOfTheHighest) {
  EXPECT_EQ(BestRecording(Entries({-5, -2, -2, -9})), 1u);
}

TEST(BestRecording, PrefersAnyReturnToNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(BestRecording(Entries({kNan, -2, kNan, -1})), 3u);
  EXPECT_EQ(BestRecording(Entries({-1, kNan})), 0u);
  EXPECT_EQ(BestRecording(Entries({kNan, kNan})), 0u);
}

}  // namespace
}  // namespace runtime
