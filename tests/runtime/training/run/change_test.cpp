#include "runtime/training/run/change.h"

#include <gtest/gtest.h>

#include "runtime/training/run/change_text.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

std::string Text(const Change& change) {
  RunRecord run = SampleRun();
  run.tasks.push_back(SampleVersion());
  return TextOf(change, run);
}

TEST(Change, IsDescribedForAPerson) {
  EXPECT_EQ(Text(SwapTask{"task", 2}), "swap task: crawling (4567cdef)");
  EXPECT_EQ(Text(SwapTask{"task", 2, true}),
            "swap task: crawling (4567cdef), what was learned is forgotten");
  EXPECT_EQ(Text(LoadShadow{"new", 1}), "load new: crawling (0123abcd)");
  EXPECT_EQ(Text(RollBackTask{"task", 1}), "rollback task: crawling (0123abcd)");
  EXPECT_EQ(Text(PromoteTask{"new"}), "promote new");
  EXPECT_EQ(Text(PromoteTask{"new", true}), "promote new, what was learned is forgotten");
  EXPECT_EQ(Text(UnloadShadow{"new"}), "unload new");
  EXPECT_EQ(Text(SetParameter{"task.gain", 0.5}), "task.gain = 0.5");
  EXPECT_EQ(Text(SetParameter{"a.mood", std::string("wild")}), "a.mood = \"wild\"");
  EXPECT_EQ(Text(SetParameter{"a.list", std::vector{1.0, 0.5}}), "a.list = [1.0,0.5]");
  EXPECT_EQ(Text(ScheduleParameter{"a.b", 0.5, int64_t{2}, 10}), "a.b: 0.5 to 2 over 10 episodes");
  EXPECT_EQ(Text(ConnectPorts{"a.b", "c.d"}), "connect a.b c.d");
  EXPECT_EQ(Text(DisconnectPorts{"a.b", "c.d"}), "disconnect a.b c.d");
  EXPECT_EQ(Text(AddModule{"NgNet", "net", {}}), "add module NgNet net");
  EXPECT_EQ(Text(RemoveModule{"net"}), "remove module net");
}

TEST(Change, SaysWhichTaskItBrings) {
  for (const Change& change :
       {Change(SwapTask{"new", 2}), Change(LoadShadow{"new", 2}), Change(RollBackTask{"new", 2})}) {
    const std::optional<TaskOfModule> brought = TaskBroughtBy(change);
    ASSERT_TRUE(brought.has_value()) << KindOf(change);
    EXPECT_EQ(brought->module, "new");
    EXPECT_EQ(brought->task, 2);
  }
  EXPECT_FALSE(TaskBroughtBy(PromoteTask{"new"}));
  EXPECT_FALSE(TaskBroughtBy(PutInQuarantine{.task = 2, .change = {}, .why = ""}));
}

TEST(Change, SaysWhetherTheLearnerIsPaidOtherwiseFromThenOn) {
  EXPECT_TRUE(ChangesReward(SwapTask{"task", 2}, "task"));
  EXPECT_TRUE(ChangesReward(RollBackTask{"task", 1}, "task"));
  EXPECT_TRUE(ChangesReward(PromoteTask{"new"}, "task"));
  EXPECT_TRUE(ChangesReward(SetParameter{"task.gain", 0.5}, "task"));
  EXPECT_TRUE(ChangesReward(ScheduleParameter{"task.gain", 0.5, 2.0, 10}, "task"));
  EXPECT_FALSE(ChangesReward(SetParameter{"tasks.gain", 0.5}, "task"));
  EXPECT_FALSE(ChangesReward(SetParameter{"learner.temperature", 0.5}, "task"));
  EXPECT_FALSE(ChangesReward(LoadShadow{"new", 2}, "task"));
  EXPECT_FALSE(ChangesReward(UnloadShadow{"new"}, "task"));
}

}  // namespace
}  // namespace runtime
