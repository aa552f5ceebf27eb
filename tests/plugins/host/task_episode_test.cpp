#include "plugins/host/task_episode.h"

#include <gmock/gmock.h>

#include <limits>

namespace host {
namespace {

using testing::ElementsAre;

// What the events of these tests pay and reach.
double paid;
taskc_int32 reached;
double measured_time_step;

void Pay(taskc_frame* frame) {
  frame->reward = paid;
  frame->terms[0] += paid;
  frame->end = reached;
  frame->logs[0].sum += paid;
  ++frame->logs[0].count;
}

void Measure(taskc_frame* frame) {
  measured_time_step = frame->time_step;
  frame->metrics[0] = frame->terms[0];
}

class TaskEpisodeTest : public testing::Test {
 protected:
  TaskEpisodeTest() {
    plugin_.terms = &term_;
    plugin_.term_count = 1;
    plugin_.metrics = &metric_;
    plugin_.metric_count = 1;
    plugin_.logs = &log_;
    plugin_.log_count = 1;
    plugin_.end_count = 1;
    plugin_.events[TASKC_END_OF_TIME_STEP] = Pay;
    plugin_.measure = Measure;
    paid = 1;
    reached = -1;
  }

  const taskc_reward_term term_{"pay", "", {0, 1}};
  const taskc_metric metric_{"so_far", "", "", TASKC_MAX};
  const taskc_log log_{"paid", "", "", TASKC_MEAN, {0, 1}};
  taskc_plugin plugin_{};
};

TEST_F(TaskEpisodeTest, SaysWhatAnEventHasDone) {
  TaskEpisode episode(plugin_);
  EXPECT_FALSE(episode.Call(TASKC_START_OF_EPISODE, 0));
  reached = 0;
  const EventOutcome outcome = episode.Call(TASKC_END_OF_TIME_STEP, 0.1).value();
  EXPECT_EQ(outcome.reward, 1);
  EXPECT_EQ(outcome.end, 0);
  EXPECT_EQ(outcome.fault, -1);
}

TEST_F(TaskEpisodeTest, WhatCannotBePaidIsNot) {
  TaskEpisode episode(plugin_);
  for (const double sum : {2e30, -2e30, std::numeric_limits<double>::quiet_NaN()}) {
    paid = sum;
    const EventOutcome outcome = episode.Call(TASKC_END_OF_TIME_STEP, 0.1).value();
    EXPECT_EQ(outcome.reward, 0);
    EXPECT_FALSE(outcome.is_paid);
  }
}

TEST_F(TaskEpisodeTest, WhatIsInNoTableIsNothing) {
  TaskEpisode episode(plugin_);
  reached = 7;
  EXPECT_EQ(episode.Call(TASKC_END_OF_TIME_STEP, 0.1)->end, -1);
}

TEST_F(TaskEpisodeTest, ReducesWhatIsMeasuredAndLoggedInAnEpisode) {
  TaskEpisode episode(plugin_);
  ASSERT_TRUE(episode.needs_measuring());
  for (int round = 0; round < 2; ++round) {
    episode.Start();
    for (const double next : {3.0, -2.0}) {
      paid = next;
      episode.NoteTimeStep(0.1);
      episode.Call(TASKC_END_OF_TIME_STEP, 0.1);
      episode.MeasureTimeStep();
    }
    episode.Call(TASKC_END_OF_EPISODE, 0);
    episode.End();
    EXPECT_THAT(episode.metrics(), ElementsAre(3));
    EXPECT_THAT(episode.logs(), ElementsAre(0.5));
    EXPECT_EQ(measured_time_step, 0.1) << "of the last time step";
  }
}

}  // namespace
}  // namespace host
