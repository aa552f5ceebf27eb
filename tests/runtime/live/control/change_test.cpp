#include "runtime/live/control/change.h"

#include <gtest/gtest.h>

#include "runtime/training/run/run_files.h"
#include "runtime/training/run/task_record.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using nlohmann::json;

std::string Text(const json& data) {
  RunRecord run = SampleRun();
  run.tasks.push_back(SampleVersion());
  return Change(data).Description(run);
}

TEST(Change, IsDescribedForAPerson) {
  EXPECT_EQ(Text({{"command", "swap"}, {"name", "task"}, {"task", 2}}),
            "swap task: crawling (4567cdef)");
  EXPECT_EQ(Text({{"command", "swap"}, {"name", "task"}, {"task", 2}, {"forget", true}}),
            "swap task: crawling (4567cdef), what was learned is forgotten");
  EXPECT_EQ(Text({{"command", "load"}, {"name", "new"}, {"task", 1}}),
            "load new: crawling (0123abcd)");
  EXPECT_EQ(Text({{"command", "rollback"}, {"name", "task"}, {"task", 1}}),
            "rollback task: crawling (0123abcd)");
  EXPECT_EQ(Text({{"command", "promote"}, {"name", "new"}, {"forget", true}}),
            "promote new, what was learned is forgotten");
  EXPECT_EQ(Text({{"command", "unload"}, {"name", "new"}}), "unload new");
  EXPECT_EQ(Text({{"command", "set"}, {"name", "task.gain"}, {"value", 0.5}}), "task.gain = 0.5");
  EXPECT_EQ(Text({{"command", "set"}, {"name", "a.mood"}, {"value", "wild"}}), "a.mood = \"wild\"");
  EXPECT_EQ(Text({{"command", "set"}, {"name", "a.b"}, {"from", 0.5}, {"to", 2}, {"episodes", 10}}),
            "a.b: 0.5 to 2 over 10 episodes");
  EXPECT_EQ(Text({{"command", "connect"}, {"first", "a.b"}, {"second", "c.d"}}), "connect a.b c.d");
  EXPECT_EQ(Text({{"command", "disconnect"}, {"first", "a.b"}, {"second", "c.d"}}),
            "disconnect a.b c.d");
  EXPECT_EQ(Text({{"command", "module_add"}, {"type", "NgNet"}, {"name", "net"}}),
            "add module NgNet net");
  EXPECT_EQ(Text({{"command", "module_remove"}, {"name", "net"}}), "remove module net");
}

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
  void Do(json data, int64_t episode = 1) { maker_.Do(Change(std::move(data)), episode); }
  std::string Refusal(const json& data) {
    return ErrorOf([&] { Do(data); });
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
  Do({{"command", "swap"}, {"name", "task"}, {"task", 2}});
  EXPECT_EQ(present_task(), 2);
  Do({{"command", "rollback"}, {"name", "task"}, {"task", 1}});
  EXPECT_EQ(present_task(), 1);
  // Where a swap before it is left out, there may be nothing to do, or no previous task.
  Do({{"command", "rollback"}, {"name", "task"}, {"task", 1}});
  EXPECT_EQ(present_task(), 1);
}

TEST_F(ChangeMakerTest, ARollbackWithoutItsSwapIsASwap) {
  Do({{"command", "rollback"}, {"name", "task"}, {"task", 2}});
  EXPECT_EQ(present_task(), 2);
  EXPECT_EQ(live_.active_task().previous()->id(), 1);
}

TEST_F(ChangeMakerTest, ASwapToTheSameTaskKeepsThePreviousOne) {
  for (int i = 0; i < 2; ++i) Do({{"command", "swap"}, {"name", "task"}, {"task", 2}});
  Do({{"command", "swap"}, {"name", "task"}, {"task", 2}, {"forget", true}});
  EXPECT_EQ(live_.active_task().previous()->id(), 1);
}

TEST_F(ChangeMakerTest, AValueEndsTheScheduleOfItsParameter) {
  Do({{"command", "set"}, {"name", "mind.pace"}, {"from", 1}, {"to", 2}, {"episodes", 3}}, 7);
  EXPECT_EQ(schedules_.all().at("mind.pace").first_episode, 7);
  EXPECT_EQ(Refusal({{"command", "set"}, {"name", "mind.pace"}, {"value", -1}}),
            "`mind.pace` must lie in 0 .. inf, and -1 does not");
  EXPECT_EQ(schedules_.all().size(), 1u);
  Do({{"command", "set"}, {"name", "mind.pace"}, {"value", 3}});
  EXPECT_TRUE(schedules_.all().empty());
}

TEST_F(ChangeMakerTest, AModuleGetsItsParameters) {
  Do({{"command", "module_add"},
      {"type", "Reader"},
      {"name", "more"},
      {"parameters", {{"count", 5}}}});
  EXPECT_EQ(live_.Get("more.count"), ParameterValue(int64_t{5}));
  EXPECT_EQ(Refusal({{"command", "module_add"},
                     {"type", "Reader"},
                     {"name", "most"},
                     {"parameters", {{"count", 10}}}}),
            "`most.count` must lie in -inf .. 9, and 10 does not");
  EXPECT_EQ(
      ErrorOf([&] { live_.graph().Find("most"); }),
      "there is no module `most`; there are `environment`, `task`, `mind`, `learner`, `more`");
}

TEST_F(ChangeMakerTest, WhatALaterVersionWroteIsRefused) {
  EXPECT_EQ(Refusal({{"command", "twist"}}), "this version of the trainer knows no change `twist`");
}

TEST_F(ChangeMakerTest, APluginThatWasDamagedIsNotLoaded) {
  std::filesystem::resize_file(folder_.path() / run_.tasks[1].plugin, 100);
  EXPECT_NE(Refusal({{"command", "swap"}, {"name", "task"}, {"task", 2}}), "");
  EXPECT_EQ(present_task(), 1);
}

}  // namespace
}  // namespace runtime
