#include "runtime/live/control/schedules.h"

#include <gmock/gmock.h>

#include "tests/runtime/live/control/small_agent.h"

namespace runtime {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(Schedule, IsLinearBetweenItsFirstAndItsLastEpisode) {
  const Schedule schedule{.from = 1, .to = 3, .first_episode = 10, .episodes = 5};
  EXPECT_EQ(schedule.At(9), 1);
  EXPECT_EQ(schedule.At(10), 1);
  EXPECT_EQ(schedule.At(11), 1.5);
  EXPECT_EQ(schedule.At(13), 2.5);
  EXPECT_EQ(schedule.At(14), 3);
  EXPECT_EQ(schedule.At(1000), 3);
  EXPECT_FALSE(schedule.IsOverAfter(13));
  EXPECT_TRUE(schedule.IsOverAfter(14));
}

TEST(Schedule, FallsAsWellAsItRises) {
  const Schedule schedule{.from = 5, .to = -5, .first_episode = 1, .episodes = 3};
  EXPECT_EQ(schedule.At(2), 0);
  EXPECT_EQ(schedule.At(3), -5);
}

TEST(Schedule, OfOneEpisodeHasItsLastValueAtOnce) {
  const Schedule schedule{.from = 1, .to = 3, .first_episode = 4, .episodes = 1};
  EXPECT_EQ(schedule.At(3), 1);
  EXPECT_EQ(schedule.At(4), 3);
  EXPECT_TRUE(schedule.IsOverAfter(4));
}

class SchedulesTest : public testing::Test {
 protected:
  ParameterValue Get(const char* parameter) const { return live_.Get(parameter); }

  SmallAgent agent_;
  LiveGraph live_{agent_.graph(), agent_.types(), agent_.context()};
  Schedules schedules_;
};

TEST_F(SchedulesTest, AreDroppedWhenTheyAreOver) {
  schedules_.Set("mind.pace", {1, 2, 7, 3});
  schedules_.Set("task.gain", {0, 4, 7, 2});
  schedules_.Apply(7, live_);
  EXPECT_EQ(Get("mind.pace"), ParameterValue(1.0));
  EXPECT_EQ(Get("task.gain"), ParameterValue(0.0));
  EXPECT_THAT(schedules_.all(), SizeIs(2));
  schedules_.Apply(8, live_);
  EXPECT_EQ(Get("mind.pace"), ParameterValue(1.5));
  EXPECT_EQ(Get("task.gain"), ParameterValue(4.0));
  EXPECT_THAT(schedules_.all(), SizeIs(1));
  schedules_.Apply(9, live_);
  EXPECT_EQ(Get("mind.pace"), ParameterValue(2.0));
  EXPECT_THAT(schedules_.all(), IsEmpty());
}

TEST_F(SchedulesTest, WholeParametersMoveInWholeSteps) {
  schedules_.Set("mind.steps", {1, 2, 1, 5});  // 1, 1.25, 1.5, 1.75, 2
  std::vector<int64_t> values;
  for (int64_t episode = 1; episode <= 5; ++episode) {
    schedules_.Apply(episode, live_);
    values.push_back(std::get<int64_t>(Get("mind.steps")));
  }
  EXPECT_THAT(values, testing::ElementsAre(1, 1, 2, 2, 2));
}

TEST_F(SchedulesTest, ANewOneReplacesTheOld) {
  schedules_.Set("mind.pace", {1, 2, 1, 10});
  schedules_.Set("mind.pace", {5, 6, 1, 10});
  schedules_.Apply(1, live_);
  EXPECT_EQ(Get("mind.pace"), ParameterValue(5.0));
  schedules_.Remove("mind.pace");
  EXPECT_THAT(schedules_.all(), IsEmpty());
}

TEST_F(SchedulesTest, OfAParameterThatIsGoneAreDropped) {
  schedules_.Set("task.gain", {1, 2, 1, 10});
  live_.Swap("task", Instance("bare", 2));
  schedules_.Apply(1, live_);
  EXPECT_THAT(schedules_.all(), IsEmpty());
}

TEST_F(SchedulesTest, OfValuesThatAreNotTakenAnyMoreAreDropped) {
  schedules_.Set("task.gain", {9, 11, 1, 3});
  schedules_.Apply(2, live_);
  EXPECT_THAT(schedules_.all(), SizeIs(1));
  schedules_.Apply(3, live_);
  EXPECT_THAT(schedules_.all(), IsEmpty());
  EXPECT_EQ(Get("task.gain"), ParameterValue(10.0));
}

}  // namespace
}  // namespace runtime
