#include "runtime/analysis/study/group_strip.h"

#include <gmock/gmock.h>

#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

TEST(DrawGroupStrip, ShowsTheLastEpisodeOfTheTypicalRun) {
  const TemporaryFolder folder;
  const StudyResults results = ReadStudyResults(folder.path(), WriteStudy(folder.path()));
  const ExperimentResult& crawling = results.experiments.front();
  const BehaviorGroup& group = crawling.groups.front();
  const GroupStrip strip = DrawGroupStrip(crawling, group, 64);
  EXPECT_EQ(strip.episode, 40);
  ASSERT_EQ(strip.times.size(), 8u);
  EXPECT_EQ(strip.times.front(), 0);
  const auto seed = static_cast<double>(group.typical + 1);
  EXPECT_NEAR(strip.times.back(), 4 + 0.2 * seed, 1e-9);  // as long as that run's recording is
  EXPECT_THAT(strip.png, testing::StartsWith("\x89PNG"));
  EXPECT_NE(strip.png, DrawGroupStrip(crawling, crawling.groups.back(), 64).png);
}

}  // namespace
}  // namespace runtime
