#include "runtime/training/run/return_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

EpisodeRecord EpisodeWith(int64_t number, double episode_return) {
  EpisodeRecord episode = SampleEpisode(number);
  episode.active.episode_return = episode_return;
  return episode;
}

TEST(ReturnStatistics, AverageTheLast20Episodes) {
  ReturnStatistics statistics;
  for (int number = 1; number <= 25; ++number) {
    statistics.Add(EpisodeWith(number, number == 3 ? 1000 : number));
  }
  EXPECT_EQ(statistics.last(), 25);
  EXPECT_DOUBLE_EQ(statistics.mean(), 15.5);  // of 6 ... 25
}

TEST(ReturnStatistics, AverageAllEpisodesAtFirst) {
  ReturnStatistics statistics;
  statistics.Add(EpisodeWith(1, 1));
  statistics.Add(EpisodeWith(2, 4));
  EXPECT_DOUBLE_EQ(statistics.mean(), 2.5);
}

TEST(ReturnStatistics, KnowTheFirstOfTheBestEpisodes) {
  ReturnStatistics statistics;
  EXPECT_EQ(statistics.best_episode(), 0);
  EXPECT_TRUE(statistics.IsBest(EpisodeWith(1, -1e300)));
  statistics.Add(EpisodeWith(1, -2));
  statistics.Add(EpisodeWith(2, 3));
  EXPECT_FALSE(statistics.IsBest(EpisodeWith(3, 3)));
  statistics.Add(EpisodeWith(3, 3));
  EXPECT_EQ(statistics.best(), 3);
  EXPECT_EQ(statistics.best_episode(), 2);
}

TEST(ReturnStatistics, TakeNoEpisodeForTheBestWhoseReturnIsNotFinite) {
  ReturnStatistics statistics;
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_FALSE(statistics.IsBest(EpisodeWith(1, bad)));
    statistics.Add(EpisodeWith(1, bad));
  }
  EXPECT_EQ(statistics.best_episode(), 0);
}

TEST(ReturnStatistics, TakeNoDivergedEpisodeForTheBest) {
  ReturnStatistics statistics;
  EpisodeRecord diverged = EpisodeWith(1, 1e9);
  diverged.active.end_kind = "diverged";
  EXPECT_FALSE(statistics.IsBest(diverged));
  statistics.Add(diverged);
  EXPECT_EQ(statistics.best_episode(), 0);
}

}  // namespace
}  // namespace runtime
