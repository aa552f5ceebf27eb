#include "runtime/analysis/study/learning.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::NanSensitiveDoubleEq;
using testing::Pair;

// Episodes with these returns, each of two seconds of CPU time.
std::vector<EpisodeRecord> EpisodesWith(const std::vector<double>& returns) {
  std::vector<EpisodeRecord> episodes;
  for (const double value : returns) {
    episodes.push_back(SampleEpisode(static_cast<int64_t>(episodes.size() + 1)));
    episodes.back().active.episode_return = value;
    episodes.back().cpu_seconds = 2;
  }
  return episodes;
}

TEST(MeanWindow, IsATwentiethOfTheRunAtMost50) {
  EXPECT_EQ(MeanWindow(1), 1);
  EXPECT_EQ(MeanWindow(200), 10);
  EXPECT_EQ(MeanWindow(1000), 50);
  EXPECT_EQ(MeanWindow(4000), 50);
}

TEST(MovingAverage, LooksBackAndSkipsWhatIsNotANumber) {
  EXPECT_THAT(MovingAverage(EpisodesWith({1, 3, NAN, 7}), 2), ElementsAre(1, 2, 3, 7));
  EXPECT_THAT(MovingAverage(EpisodesWith({NAN, 5}), 1),
              ElementsAre(NanSensitiveDoubleEq(NAN), DoubleEq(5)));
}

// Averages of two: 0, 0, 5, 40, 75, 85, 95, 100; 80 is passed in the sixth episode.
TEST(FindMostLearned, IsWhereFourFifthsOfTheWayAreDone) {
  const auto found = FindMostLearned(EpisodesWith({0, 0, 10, 70, 80, 90, 100, 100}), 2);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->episode, 6);
  EXPECT_EQ(found->cpu_seconds, 12);
}

TEST(FindMostLearned, GoesFromTheFirstMeanNotFromZero) {
  const auto found = FindMostLearned(EpisodesWith({-40, -40, -30, -20, -9, -9, 0, 0}), 1);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->episode, 7);  // -9 is less than -8
}

// A hundred runs whose returns are chance alone; half of them end higher than they began.
TEST(FindMostLearned, IsNowhereWhereNothingWasLearned) {
  std::mt19937 random(1);
  int found = 0;
  for (int run = 0; run < 100; ++run) {
    std::vector<double> returns;
    for (int episode = 0; episode < 100; ++episode) {
      returns.push_back(static_cast<double>(random() % 1000));
    }
    if (FindMostLearned(EpisodesWith(returns), 5).has_value()) ++found;
  }
  EXPECT_LE(found, 1);
}

// The same chance, on top of something that is learned.
TEST(FindMostLearned, SeesWhatWasLearnedBehindTheNoise) {
  std::mt19937 random(1);
  std::vector<double> returns;
  for (int episode = 0; episode < 400; ++episode) {
    returns.push_back(static_cast<double>(random() % 1000) + (episode < 200 ? 0 : 1000));
  }
  const auto found = FindMostLearned(EpisodesWith(returns), 20);
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->episode, 200);
  EXPECT_LE(found->episode, 220);
}

TEST(FindMostLearned, IsNowhereInARunThatGotNoBetterOrIsShort) {
  EXPECT_FALSE(FindMostLearned(EpisodesWith({5, 5, 5, 5}), 2).has_value());
  EXPECT_FALSE(FindMostLearned(EpisodesWith({5, 9, 1, 1}), 2).has_value());
  EXPECT_FALSE(FindMostLearned(EpisodesWith({1, 2, 3}), 2).has_value());
  EXPECT_FALSE(FindMostLearned({}, 1).has_value());
}

TEST(MeansAtTheEnd, AreOfTheLastEpisodesByName) {
  std::vector<EpisodeRecord> episodes = EpisodesWith({100, 2, 4});
  episodes[1].active.terms = {1, -4};
  episodes[2].active.terms = {2, NAN};
  episodes[1].active.metrics = {NAN};
  episodes[2].active.metrics = {NAN};
  const FinalMeans means = MeansAtTheEnd(SampleRun(), episodes, 2);
  EXPECT_EQ(means.episode_return, 3);
  EXPECT_THAT(means.terms, ElementsAre(Pair("fall", -4), Pair("speed", 1.5)));
  EXPECT_THAT(means.metrics, ElementsAre());
}

TEST(MeansAtTheEnd, KnowTermsOfOtherVersionsByTheirNames) {
  RunRecord run = SampleRun();
  run.tasks.push_back(SampleVersion());
  std::vector<EpisodeRecord> episodes = EpisodesWith({1, 2});
  episodes[0].active.terms = {3, -4};
  episodes[1].active = SampleShadow();  // effort 0.5, speed 1, fall -4
  const FinalMeans means = MeansAtTheEnd(run, episodes, 5);
  EXPECT_THAT(means.terms, ElementsAre(Pair("effort", 0.5), Pair("fall", -4), Pair("speed", 2)));
}

}  // namespace
}  // namespace runtime
