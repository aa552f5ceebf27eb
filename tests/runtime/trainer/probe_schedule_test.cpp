#include "runtime/trainer/train/probe_schedule.h"

#include <gtest/gtest.h>

namespace runtime {
namespace {

// An episode takes a second for each search that goes on.
TEST(ProbeSchedule, TheBetterHalfGoesOnAfterAThirdOfTheTime) {
  ProbeSchedule schedule(900, 4, false);
  ProbeSchedule::Round round = schedule.First();
  double elapsed = 0, elapsed_with_all = 0;
  int64_t done = 0;
  while (round.episodes > 0) {
    const double seconds = static_cast<double>(round.episodes * int64_t(round.searches));
    elapsed += seconds;
    done += round.episodes;
    if (round.searches == 4) elapsed_with_all = elapsed;
    round = schedule.Next(elapsed, seconds, round.episodes, done);
    EXPECT_TRUE(round.searches == 4 || round.searches == 2);
  }
  EXPECT_NEAR(elapsed_with_all, 300, 30);
  EXPECT_NEAR(elapsed, 900, 30);
}

TEST(ProbeSchedule, TwoSearchesAreNeverHalved) {
  for (const size_t searches : {1, 2}) {
    ProbeSchedule schedule(10, searches, false);
    EXPECT_EQ(schedule.Next(9, 1, 1, 9).searches, searches);
  }
  EXPECT_EQ(ProbeSchedule(10, 4, true).Next(5, 1, 1, 9).searches, 4u);  // what is left of more
}

}  // namespace
}  // namespace runtime
