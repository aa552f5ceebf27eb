#include "runtime/training/run/task_spans.h"

#include <gmock/gmock.h>

#include "tests/runtime/training/run/sample_run.h"

namespace runtime {

bool operator==(const TaskSpan& a, const TaskSpan& b) {
  return a.task == b.task && a.first == b.first && a.last == b.last;
}

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Episodes from 1 on with these active tasks.
std::vector<EpisodeRecord> EpisodesOf(const std::vector<int64_t>& tasks) {
  std::vector<EpisodeRecord> episodes;
  for (const int64_t task : tasks) {
    episodes.push_back(SampleEpisode(static_cast<int64_t>(episodes.size() + 1)));
    episodes.back().active.task = task;
  }
  return episodes;
}

TEST(ActiveTasks, AreNoneBeforeTheFirstEpisode) { EXPECT_THAT(ActiveTasks({}), IsEmpty()); }

TEST(ActiveTasks, AreOneWithoutASwap) {
  EXPECT_THAT(ActiveTasks(EpisodesOf({1, 1, 1})), ElementsAre(TaskSpan{1, 1, 3}));
}

TEST(ActiveTasks, CountATaskAgainThatIsRolledBackTo) {
  EXPECT_THAT(ActiveTasks(EpisodesOf({1, 1, 2, 1})),
              ElementsAre(TaskSpan{1, 1, 2}, TaskSpan{2, 3, 3}, TaskSpan{1, 4, 4}));
}

}  // namespace
}  // namespace runtime
