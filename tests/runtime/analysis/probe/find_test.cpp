#include "runtime/analysis/probe/find.h"

#include <gmock/gmock.h>

#include "runtime/analysis/probe/probe_figures.h"
#include "runtime/base/user_error.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class FindTest : public testing::Test {
 protected:
  // A search whose best episode is its last one: a crawl at this speed, with a thousand times as
  // much as its return.
  void AddSearch(uint64_t seed, double speed, bool is_best = true) {
    runs_.push_back(folder_.path() / ("seed" + std::to_string(seed)));
    WriteStudyRun(runs_.back(), {.seed = seed, .speed = speed, .is_best = is_best});
  }
  ProbeResults Read() const { return ReadProbe(folder_.path(), runs_); }

 private:
  TemporaryFolder folder_;
  std::vector<std::filesystem::path> runs_;
};

TEST(MotionExtremes, AreThoseOfTheBase) {
  Motion motion{0.02, 2, {}, {}};
  for (const double x : {0.0, 0.01, 0.05, 0.06}) {
    motion.positions.emplace_back(x, 0, 0.2 + x);
    motion.positions.emplace_back(100 * x, 0, 9);  // another link
  }
  motion.orientations.assign(8, Eigen::Quaterniond::Identity());
  const MotionExtremes extremes = ExtremesOf(motion);
  EXPECT_NEAR(extremes.speed, 0.04 * std::sqrt(2) / 0.02, 1e-12);
  EXPECT_NEAR(extremes.height, 0.26, 1e-12);
}

TEST_F(FindTest, ShowsTheBestOfEachKindOfMotion) {
  AddSearch(1, 0.1);
  AddSearch(2, 0.11);
  AddSearch(3, 0.5);
  const ProbeResults results = Read();
  EXPECT_EQ(results.searches, 3);
  EXPECT_EQ(results.episodes, 120);
  EXPECT_EQ(results.cpu_seconds, 180);
  ASSERT_THAT(results.finds, SizeIs(2));
  EXPECT_EQ(results.finds[0].run, "seed3");
  EXPECT_EQ(results.finds[0].searches, 1);
  EXPECT_EQ(results.finds[1].run, "seed2");
  EXPECT_EQ(results.finds[1].searches, 2);
  EXPECT_EQ(results.finds[1].episode.number, 40);
  // The trunk rises and sinks besides.
  EXPECT_GT(results.finds[1].extremes.speed, 0.11);
  EXPECT_LT(results.finds[1].extremes.speed, 1);
  EXPECT_TRUE(results.finds[1].is_sound());
}

// The humanoid's description says that its base is never faster than 10 m/s.
TEST_F(FindTest, WhatNoSoundSimulationDoesIsNoFind) {
  AddSearch(1, 0.1);
  AddSearch(2, 13);
  const ProbeResults results = Read();
  ASSERT_THAT(results.finds, SizeIs(2));
  EXPECT_EQ(results.finds[0].run, "seed1");  // though it is paid less
  EXPECT_FALSE(results.finds[1].is_sound());
  EXPECT_THAT(results.finds[1].beyond, ElementsAre(HasSubstr("a speed of 13.")));
}

TEST_F(FindTest, OnlyTheBestEpisodesOfASearchAreFinds) {
  AddSearch(1, 0.1, false);
  EXPECT_THAT(Read().finds, IsEmpty());
}

TEST_F(FindTest, TellsWhatIsPaidFor) {
  AddSearch(4, 0.5);
  const auto figures = ProbeFigures(Read());
  EXPECT_EQ(figures["task"], "crawling");
  const auto& find = figures["finds"][0];
  EXPECT_EQ(find["name"], "A");
  EXPECT_EQ(find["seed"], 4);
  EXPECT_EQ(find["end"]["reason"], "time is up");
  EXPECT_THAT(find["terms"], SizeIs(3));
  const double paid = find["terms"][0]["value"], taken = find["terms"][1]["value"];
  EXPECT_DOUBLE_EQ(find["terms"][0]["share"], paid / (paid - taken));
  EXPECT_DOUBLE_EQ(find["return"], paid + taken);
}

TEST_F(FindTest, NothingIsFoundBeforeTheFirstEpisode) { EXPECT_THROW(Read(), UserError); }

}  // namespace
}  // namespace runtime
