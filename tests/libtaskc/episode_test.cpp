#include <gmock/gmock.h>
#include <taskc/host.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/libtaskc/opened_task.h"

namespace libtaskc {
namespace {

using testing::HasSubstr;

class EpisodeTest : public testing::Test {
 protected:
  EpisodeTest() { Bind(instance_, world_); }
  void Start(taskc_uint64 seed = 1) {
    ASSERT_EQ(taskc_start_episode(instance_, seed, nullptr), TASKC_OK) << taskc_error();
  }
  taskc_result Tell(int event, double time_step = 0) {
    taskc_result result{};
    EXPECT_EQ(taskc_event(instance_, event, time_step, &result), TASKC_OK) << taskc_error();
    return result;
  }
  std::string Reason() const {
    const char* reason = nullptr;
    taskc_ended(instance_, &reason);
    return reason == nullptr ? "null" : reason;
  }

  OpenedTask task_{"each"};
  Instance instance_{task_};
  World world_;
};

TEST_F(EpisodeTest, CountsAsTheTrainerDoes) {
  Start();
  EXPECT_EQ(Tell(TASKC_START_OF_ACTION).reward, 0.5);
  EXPECT_EQ(Tell(TASKC_START_OF_TIME_STEP, 0.5).reward, 0);
  world_.place[2] = 2;
  EXPECT_EQ(Tell(TASKC_END_OF_TIME_STEP, 0.5).reward, 1);
  world_.place[0] = 2;
  world_.place[2] = 1;
  EXPECT_EQ(Tell(TASKC_END_OF_TIME_STEP, 0.5).reward, 2);
  EXPECT_EQ(Tell(TASKC_END_OF_ACTION).reward, 0.75);
  EXPECT_EQ(taskc_ended(instance_, nullptr), -1);
  ASSERT_EQ(taskc_end_episode(instance_, TASKC_TRUNCATED, nullptr), TASKC_OK);
  EXPECT_EQ(taskc_return(instance_), 4.25);
  double moved = 0;
  double height = 0;
  double ways = 0;
  ASSERT_EQ(taskc_get_term(instance_, "moved", &moved), TASKC_OK);
  ASSERT_EQ(taskc_get_metric(instance_, "height", &height), TASKC_OK);
  ASSERT_EQ(taskc_get_log(instance_, "ways", &ways), TASKC_OK);
  EXPECT_EQ(moved, 3);
  EXPECT_EQ(height, 2);
  EXPECT_EQ(ways, 3);
  EXPECT_EQ(taskc_terms(instance_)[0], 0.5);
  EXPECT_EQ(taskc_get_term(nullptr, "moved", &moved), TASKC_ERROR_NULL);
  EXPECT_EQ(taskc_get_term(instance_, "movd", &moved), TASKC_ERROR_UNKNOWN_NAME);
  EXPECT_THAT(taskc_error(), HasSubstr("has no reward term `movd`: did you mean `moved`?"));
}

TEST_F(EpisodeTest, SaysHowItHasEnded) {
  Start();
  world_.place[0] = 6;
  EXPECT_EQ(Tell(TASKC_END_OF_TIME_STEP, 0.5).end, 0);
  EXPECT_EQ(taskc_ended(instance_, nullptr), TASKC_SUCCESS);
  EXPECT_EQ(Reason(), "arrived");
  // What has ended does nothing more, whatever the host says.
  EXPECT_EQ(Tell(TASKC_END_OF_TIME_STEP, 0.5).reward, 0);
  ASSERT_EQ(taskc_end_episode(instance_, TASKC_FAILURE, nullptr), TASKC_OK);
  EXPECT_EQ(taskc_ended(instance_, nullptr), TASKC_SUCCESS);
  Start();
  EXPECT_EQ(Reason(), "null");
}

TEST_F(EpisodeTest, WhatIsRequiredTruncates) {
  Start();
  world_.place[0] = 6;
  world_.place[1] = 9.5;
  const taskc_result result = Tell(TASKC_END_OF_TIME_STEP, 0.5);
  EXPECT_EQ(result.violation, 0);
  EXPECT_EQ(result.end, -1);
  EXPECT_EQ(taskc_ended(instance_, nullptr), TASKC_TRUNCATED);
  EXPECT_EQ(Reason(), "requirement: it stays near");
}

TEST_F(EpisodeTest, TheHostMayEndIt) {
  Start();
  ASSERT_EQ(taskc_end_episode(instance_, TASKC_FAILURE, nullptr), TASKC_OK);
  EXPECT_EQ(taskc_ended(instance_, nullptr), TASKC_FAILURE);
  EXPECT_EQ(Reason(), "");
}

TEST_F(EpisodeTest, WhatIsNotFiniteIsNotPaid) {
  Start();
  world_.place[0] = std::numeric_limits<double>::quiet_NaN();
  const taskc_result result = Tell(TASKC_END_OF_TIME_STEP, 0.5);
  EXPECT_EQ(result.reward, 0);
  EXPECT_STREQ(task_.table().terms[result.fault].name, "moved");
  EXPECT_EQ(taskc_fault_count(instance_), 1);
}

TEST_F(EpisodeTest, PhasesFollowTheSensors) {
  Start();
  EXPECT_EQ(taskc_present_phase(instance_), 0);
  world_.steps = 4;
  Tell(TASKC_END_OF_TIME_STEP, 0.5);
  EXPECT_EQ(taskc_present_phase(instance_), 1);
}

TEST_F(EpisodeTest, ParamsAreSetByNameAndUnit) {
  EXPECT_EQ(taskc_set_param(instance_, "gain", "", 4), TASKC_OK);
  double gain = 0;
  EXPECT_EQ(taskc_get_param(instance_, "gain", &gain), TASKC_OK);
  EXPECT_EQ(gain, 4);
  Start();
  EXPECT_EQ(Tell(TASKC_END_OF_TIME_STEP, 0.5).reward, 2);
  EXPECT_EQ(taskc_set_param(instance_, "reach", "km", 4), TASKC_ERROR_WRONG_UNIT);
  EXPECT_STREQ(taskc_error(), "`reach` is in `m`, not in `km`");
  EXPECT_EQ(taskc_set_param(instance_, "reach", "m", 9), TASKC_ERROR_OUT_OF_RANGE);
  EXPECT_STREQ(taskc_error(), "the param `reach` must be within 1 .. 8 m, not 9");
  EXPECT_EQ(taskc_set_param(instance_, "reach", "m", std::nan("")), TASKC_ERROR_OUT_OF_RANGE);
  EXPECT_EQ(taskc_set_param(instance_, "bonus", "", 1.5), TASKC_ERROR_OUT_OF_RANGE);
  EXPECT_STREQ(taskc_error(), "the param `bonus` is an int, and 1.5 is none");
  EXPECT_EQ(taskc_set_param(instance_, "gian", "", 1), TASKC_ERROR_UNKNOWN_NAME);
}

TEST_F(EpisodeTest, GoalsFollowTheSeedOrAreHeld) {
  double first[2];
  double second[2];
  Start(7);
  ASSERT_EQ(taskc_get_goal(instance_, "target", first), TASKC_OK);
  Start(8);
  taskc_get_goal(instance_, "target", second);
  EXPECT_NE(first[0], second[0]);
  Start(7);
  taskc_get_goal(instance_, "target", second);
  EXPECT_EQ(first[0], second[0]);
  const double held[] = {0.5, -0.5};
  ASSERT_EQ(taskc_hold_goal(instance_, "target", "m", held), TASKC_OK);
  Start(9);
  taskc_get_goal(instance_, "target", second);
  EXPECT_EQ(second[1], -0.5);
  ASSERT_EQ(taskc_release_goal(instance_, "target"), TASKC_OK);
  Start(7);
  taskc_get_goal(instance_, "target", second);
  EXPECT_EQ(first[0], second[0]);
  const double endless[] = {0, INFINITY};
  EXPECT_EQ(taskc_hold_goal(instance_, "target", "m", endless), TASKC_ERROR_OUT_OF_RANGE);
}

TEST_F(EpisodeTest, EventsOutsideOfAnEpisodeAreRefused) {
  EXPECT_EQ(taskc_event(instance_, TASKC_END_OF_TIME_STEP, 0.5, nullptr), TASKC_ERROR_WRONG_ORDER);
  EXPECT_THAT(taskc_error(), HasSubstr("call `taskc_start_episode`"));
  EXPECT_EQ(taskc_end_episode(instance_, TASKC_TRUNCATED, nullptr), TASKC_ERROR_WRONG_ORDER);
  const double* numbers = nullptr;
  EXPECT_EQ(taskc_observe(instance_, &numbers), TASKC_ERROR_WRONG_ORDER);
  Start();
  EXPECT_EQ(taskc_event(instance_, TASKC_START_OF_EPISODE, 0, nullptr), TASKC_ERROR_WRONG_ORDER);
  EXPECT_EQ(taskc_event(instance_, TASKC_END_OF_TIME_STEP, -1, nullptr), TASKC_ERROR_OUT_OF_RANGE);
  EXPECT_EQ(taskc_end_episode(instance_, 5, nullptr), TASKC_ERROR_OUT_OF_RANGE);
}

TEST(Start, IsDrawnIntoThePoseOfTheHost) {
  const OpenedTask task("starting");
  const Instance instance(task);
  const char* pose = nullptr;
  ASSERT_EQ(taskc_draw_pose(instance, 3, &pose), TASKC_OK) << taskc_error();
  EXPECT_STREQ(pose, "standing");
  double* yaw = nullptr;
  ASSERT_EQ(taskc_get_start_value(instance, "base.yaw", &yaw), TASKC_OK) << taskc_error();
  *yaw = 0;
  ASSERT_EQ(taskc_draw_start(instance, 0), TASKC_OK);
  const double first = *yaw;
  EXPECT_NE(first, 0);
  *yaw = 0;
  ASSERT_EQ(taskc_draw_start(instance, 1), TASKC_OK);
  EXPECT_NE(*yaw, first);
  EXPECT_EQ(taskc_get_start_value(instance, "base.pitch", &yaw), TASKC_ERROR_UNKNOWN_NAME);
}

}  // namespace
}  // namespace libtaskc
