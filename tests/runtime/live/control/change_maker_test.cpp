#include "runtime/live/control/change_maker.h"

#include <gtest/gtest.h>

#include "runtime/training/run/run_files.h"
#include "runtime/training/run/task_record.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

class ChangeMakerTest : public testing::Test {
 protected:
  ChangeMakerTest() {
    run_.tasks.clear();
    for (const char* plugin : {"steady", "other"}) {
      TaskRecord task = DescribeTask(Plugin(PluginFile(plugin)).table(), "task");
      task.id = static_cast<int64_t>(run_.tasks.size()) + 1;
      task.plugin = KeepPlugin(PluginFile(plugin), folder_.path());
      run_.tasks.push_back(std::move(task));
    }
  }
  void Do(const Change& change, int64_t episode = 1) {
    maker_.Do(change, {.episode = episode, .plugin = nullptr});
  }
  std::string Refusal(const Change& change) {
    return ErrorOf([&] { Do(change); });
  }
  int64_t present_task() const { return live_.active_task().instance().id(); }

  TemporaryFolder folder_;
  SmallAgent agent_;
  LiveGraph live_{agent_.graph(), agent_.types(), agent_.context()};
  Schedules schedules_;
  RunRecord run_ = SampleRun();
  ChangeMaker maker_{live_, schedules_, run_, folder_.path()};
};

TEST_F(ChangeMakerTest, ARollbackGoesToTheTaskThatItNames) {
  Do(SwapTask{"task", 2});
  EXPECT_EQ(present_task(), 2);
  Do(RollBackTask{"task", 1});
  EXPECT_EQ(present_task(), 1);
  // Where a swap before it is left out, there may be nothing to do, or no previous task.
  Do(RollBackTask{"task", 1});
  EXPECT_EQ(present_task(), 1);
}

TEST_F(ChangeMakerTest, ARollbackWithoutItsSwapIsASwap) {
  Do(RollBackTask{"task", 2});
  EXPECT_EQ(present_task(), 2);
  EXPECT_EQ(live_.active_task().previous()->id(), 1);
}

TEST_F(ChangeMakerTest, ASwapToTheSameTaskKeepsThePreviousOne) {
  for (int i = 0; i < 2; ++i) Do(SwapTask{"task", 2});
  Do(SwapTask{"task", 2, true});
  EXPECT_EQ(live_.active_task().previous()->id(), 1);
}

TEST_F(ChangeMakerTest, APluginThatIsLoadedAlreadyIsNotLoadedAgain) {
  const auto plugin = std::make_shared<const Plugin>(PluginFile("other"));
  const ChangeMaker::Circumstances loaded{.episode = 1, .plugin = plugin};
  maker_.Do(SwapTask{"task", 2}, loaded);
  EXPECT_EQ(live_.active_task().instance().plugin(), plugin);
  maker_.Do(LoadShadow{"shadow", 2}, loaded);
  EXPECT_EQ(live_.FindTask("shadow").instance().plugin(), plugin);
  Do(RollBackTask{"task", 1});
  Do(SwapTask{"task", 1, true});
  Do(UnloadShadow{"shadow"});
  maker_.Do(RollBackTask{"task", 2}, loaded);
  EXPECT_EQ(live_.active_task().instance().plugin(), plugin);
}

TEST_F(ChangeMakerTest, AValueEndsTheScheduleOfItsParameter) {
  Do(ScheduleParameter{"mind.pace", int64_t{1}, int64_t{2}, 3}, 7);
  EXPECT_EQ(schedules_.all().at("mind.pace").first_episode, 7);
  EXPECT_EQ(Refusal(SetParameter{"mind.pace", int64_t{-1}}),
            "`mind.pace` must lie in 0 .. inf, and -1 does not");
  EXPECT_EQ(schedules_.all().size(), 1u);
  Do(SetParameter{"mind.pace", int64_t{3}});
  EXPECT_TRUE(schedules_.all().empty());
}

TEST_F(ChangeMakerTest, AGoalIsHeldUntilItIsReleased) {
  const TaskGoals& goals = live_.active_task().instance().goals();
  Do(HoldGoal{"task.aim", std::vector{2.5, -1.0}});
  EXPECT_EQ(goals.Value(0), (std::vector{2.5, -1.0}));
  EXPECT_TRUE(goals.IsHeld(0));
  Do(ReleaseGoal{"task.aim"});
  EXPECT_FALSE(goals.IsHeld(0));
}

TEST_F(ChangeMakerTest, AGoalThatDoesNotExistOrFitIsRefused) {
  EXPECT_EQ(Refusal(HoldGoal{"aim", 1.0}),
            "`aim` is not a goal: write MODULE.GOAL, such as `task.aim`");
  EXPECT_EQ(Refusal(HoldGoal{"task.time", 1.0}),
            "the task `steady` has no goal `time`; its goals are aim");
  EXPECT_EQ(Refusal(HoldGoal{"task.aim", 1.0}), "the goal `aim` has 2 elements, not 1");
  EXPECT_EQ(Refusal(HoldGoal{"task.aim", std::string("far")}),
            "`task.aim` is made of numbers, and `far` is not one");
  EXPECT_EQ(Refusal(ReleaseGoal{"task.time"}),
            "the task `steady` has no goal `time`; its goals are aim");
}

TEST_F(ChangeMakerTest, AModuleGetsItsParameters) {
  Do(AddModule{"Reader", "more", {{"count", int64_t{5}}}});
  EXPECT_EQ(live_.Get("more.count"), ParameterValue(int64_t{5}));
  EXPECT_EQ(Refusal(AddModule{"Reader", "most", {{"count", int64_t{10}}}}),
            "`most.count` must lie in -inf .. 9, and 10 does not");
  EXPECT_EQ(
      ErrorOf([&] { live_.graph().Find("most"); }),
      "there is no module `most`; there are `environment`, `task`, `mind`, `learner`, `more`");
}

TEST_F(ChangeMakerTest, WhatALaterVersionWroteIsRefused) {
  EXPECT_EQ(Refusal(UnknownChange{"twist", "{}"}),
            "this version of the trainer knows no change `twist`");
}

TEST_F(ChangeMakerTest, APluginThatWasDamagedIsNotLoaded) {
  std::filesystem::resize_file(folder_.path() / run_.tasks[1].plugin, 100);
  EXPECT_NE(Refusal(SwapTask{"task", 2}), "");
  EXPECT_EQ(present_task(), 1);
}

}  // namespace
}  // namespace runtime
