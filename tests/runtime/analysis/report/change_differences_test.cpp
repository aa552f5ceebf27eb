#include "runtime/analysis/report/change_differences.h"

#include <gmock/gmock.h>

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::Eq;
using Replaced = TaskReplacement;

class TaskReplacementsTest : public testing::Test {
 protected:
  TaskReplacementsTest() {
    for (int64_t id = 1; id <= 4; ++id) {
      TaskRecord task;
      task.id = id;
      task.module = "task";
      run_.tasks.push_back(task);
    }
  }

  void Do(Change change) {
    ChangeRecord record;
    record.id = static_cast<int64_t>(changes_.size()) + 1;
    record.change = std::move(change);
    changes_.push_back(record);
  }
  std::vector<std::optional<Replaced>> Replacements() const {
    return TaskReplacements(run_, changes_);
  }

  RunRecord run_;
  std::vector<ChangeRecord> changes_;
};

TEST_F(TaskReplacementsTest, SwapsAndRollbacksFollowOneAnother) {
  Do(SwapTask{"task", 2});
  Do(SetParameter{"task.gain", int64_t{2}});
  Do(SwapTask{"task", 3});
  Do(RollBackTask{"task", 1});
  EXPECT_THAT(Replacements(), ElementsAre(Eq(Replaced{1, 2}), Eq(std::nullopt), Eq(Replaced{2, 3}),
                                          Eq(Replaced{3, 1})));
}

TEST_F(TaskReplacementsTest, AShadowIsComparedWithTheActiveTaskAndThenWithItself) {
  Do(LoadShadow{"careful", 2});
  Do(SwapTask{"careful", 3});
  Do(PromoteTask{"careful"});
  Do(LoadShadow{"third", 4});
  EXPECT_THAT(Replacements(), ElementsAre(Eq(Replaced{1, 2}), Eq(Replaced{2, 3}),
                                          Eq(Replaced{1, 3}), Eq(Replaced{3, 4})));
}

TEST_F(TaskReplacementsTest, WhatIsInQuarantineHasReplacedNothing) {
  Do(SwapTask{"task", 2});
  Do(PutInQuarantine{.task = 2, .change = {}, .why = "it crashes"});
  Do(SwapTask{"task", 3});
  Do(PutInQuarantine{.task = {}, .change = 3, .why = "it loops"});
  Do(SwapTask{"task", 4});
  EXPECT_THAT(Replacements(), ElementsAre(Eq(std::nullopt), Eq(std::nullopt), Eq(std::nullopt),
                                          Eq(std::nullopt), Eq(Replaced{1, 4})));
}

TEST_F(TaskReplacementsTest, ATaskThatTheRecordLacksIsComparedWithNothing) {
  Do(SwapTask{"task", 9});
  Do(SwapTask{"other", 2});
  EXPECT_THAT(Replacements(), ElementsAre(Eq(std::nullopt), Eq(std::nullopt)));
}

}  // namespace
}  // namespace runtime
