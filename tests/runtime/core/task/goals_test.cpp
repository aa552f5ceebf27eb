// What a task draws, what it is told, and what of it is noted.
#include <gmock/gmock.h>

#include <sstream>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/universal_task.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::SizeIs;

class GoalsTest : public testing::Test {
 protected:
  std::unique_ptr<UniversalTask> MakeTask(uint64_t seed) {
    auto task = std::make_unique<UniversalTask>(
        "task", robot_, std::make_unique<TaskInstance>(LoadTask("told")), seed);
    task->SetRole(UniversalTask::Role::kActive);
    return task;
  }
  static const TaskGoals& GoalsOf(const UniversalTask& task) { return task.instance().goals(); }
  static double DrawnSeed(const UniversalTask& task) { return GoalsOf(task).Value(0)[0]; }
  static auto IsDraw(size_t goal, double time, double last) {
    return testing::AllOf(
        Field(&GoalDraw::goal, goal), Field(&GoalDraw::time, time),
        testing::Truly([=](const GoalDraw& draw) { return draw.value.back() == last; }));
  }

  robot::RobotDescription robot_ = Walker();
  ModuleGraph graph_;
  std::unique_ptr<UniversalTask> task_ = MakeTask(5);
};

TEST_F(GoalsTest, EachDrawIsNotedWithItsTime) {
  task_->on_start_of_episode();
  task_->on_end_of_time_step(0.5);
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(GoalsOf(*task_).draws(),
              ElementsAre(IsDraw(0, 0, 0), IsDraw(1, 0, 1), IsDraw(0, 0.5, 1), IsDraw(0, 1, 2)));
  task_->on_end_of_episode({});
  task_->on_start_of_episode();
  EXPECT_THAT(GoalsOf(*task_).draws(), ElementsAre(IsDraw(0, 0, 0), IsDraw(1, 0, 1)));
}

TEST_F(GoalsTest, DependOnTheSeedOfTheRunAndTheNumberOfTheEpisode) {
  const auto seed_of = [&](uint64_t run, int64_t episode) {
    const auto task = MakeTask(run);
    task->SetNextEpisode(episode);
    task->on_start_of_episode();
    return DrawnSeed(*task);
  };
  EXPECT_EQ(seed_of(5, 1), seed_of(5, 1));
  EXPECT_NE(seed_of(5, 1), seed_of(6, 1));
  EXPECT_NE(seed_of(5, 1), seed_of(5, 2));
  // Also of a task that has seen the episodes before, or has come later.
  task_->on_start_of_episode();
  EXPECT_EQ(DrawnSeed(*task_), seed_of(5, 1));
  task_->on_end_of_episode({});
  task_->on_start_of_episode();
  EXPECT_EQ(DrawnSeed(*task_), seed_of(5, 2));
}

TEST_F(GoalsTest, AHeldGoalStaysAndIsNotedInEachEpisode) {
  const size_t place = task_->FindGoal("place");
  task_->on_start_of_episode();
  task_->HoldGoal(place, std::vector{3.0, -4.0});
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(GoalsOf(*task_).Value(place), ElementsAre(3, -4));
  EXPECT_THAT(GoalsOf(*task_).draws(),
              ElementsAre(IsDraw(0, 0, 0), IsDraw(1, 0, 1), IsDraw(0, 0, -4)));
  task_->on_end_of_episode({});
  task_->on_start_of_episode();
  EXPECT_THAT(GoalsOf(*task_).draws(), ElementsAre(IsDraw(0, 0, -4), IsDraw(1, 0, 1)));
  task_->ReleaseGoal(place);
  task_->on_end_of_time_step(0.5);
  EXPECT_THAT(GoalsOf(*task_).Value(place)[1], 0);
}

TEST_F(GoalsTest, AGoalOfIntsTakesWholeNumbers) {
  task_->HoldGoal(task_->FindGoal("side"), std::vector{-7.0});
  EXPECT_THAT(GoalsOf(*task_).Value(1), ElementsAre(-7));
}

TEST_F(GoalsTest, WhatFitsNoGoalIsRefused) {
  EXPECT_EQ(MessageOf([&] { task_->FindGoal("speed"); }),
            "the task `told` has no goal `speed`; its goals are place, side");
  EXPECT_EQ(MessageOf([&] { task_->HoldGoal(0, std::vector{1.0}); }),
            "the goal `place` has 2 elements, not 1");
}

TEST_F(GoalsTest, AHeldGoalSurvivesACheckpointAndASwap) {
  task_->HoldGoal(0, std::vector{3.0, -4.0});
  std::stringstream state;
  task_->Save(state);
  const auto other = MakeTask(5);
  other->Load(state);
  EXPECT_TRUE(GoalsOf(*other).IsHeld(0));
  other->on_start_of_episode();
  EXPECT_THAT(GoalsOf(*other).Value(0), ElementsAre(3, -4));
  other->Swap(std::make_unique<TaskInstance>(LoadTask("told"), 2), graph_);
  EXPECT_TRUE(GoalsOf(*other).IsHeld(0));
  EXPECT_THAT(GoalsOf(*other).draws(), SizeIs(2));  // of the episode in which it was swapped
  other->on_end_of_time_step(0.5);
  EXPECT_THAT(GoalsOf(*other).draws(), SizeIs(2));
}

TEST_F(GoalsTest, ATableWithAGoalOutsideTheMemoryIsRefused) {
  EXPECT_EQ(
      MessageOf([&] { LoadTask("goal_outside"); }),
      "goal_outside.so: its table is damaged: the goal `place` lies outside the memory; build "
      "it again with `taskc build`");
}

}  // namespace
}  // namespace runtime
