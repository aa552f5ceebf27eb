#include "runtime/live/control/versions.h"

#include <gtest/gtest.h>

#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"

namespace runtime {
namespace {

RunRecord RunWithVersions() {
  RunRecord run = SampleRun();  // 0123abcd
  run.tasks.push_back(SampleVersion());
  run.tasks.back().task_hash = "0124cdef";
  run.tasks.push_back(SampleVersion());
  run.tasks.back().module = "shadow";
  run.tasks.back().id = 3;
  return run;
}

TEST(Versions, AreFoundByNumberAndByHash) {
  const RunRecord run = RunWithVersions();
  EXPECT_EQ(FindVersion(run, "task", "1").id, 1);
  EXPECT_EQ(FindVersion(run, "task", "0124").id, 2);
  EXPECT_EQ(FindVersion(run, "shadow", "4567cdef").id, 3);
}

TEST(Versions, AreListedWhereNoneIsMeant) {
  const RunRecord run = RunWithVersions();
  const std::string list = "it has had 1 = crawling (0123abcd), 2 = crawling (0124cdef)";
  EXPECT_EQ(ErrorOf([&] { FindVersion(run, "task", "3"); }),
            "`task` has had no version `3`: " + list);
  EXPECT_EQ(ErrorOf([&] { FindVersion(run, "task", "012"); }),
            "`task` has had several versions `012`: " + list);
  EXPECT_EQ(ErrorOf([&] { FindVersion(run, "task", ""); }),
            "`task` has had no version ``: " + list);
}

TEST(Versions, AreTheSameWhereTheirTextIs) {
  TaskRecord moved = SampleTask();
  moved.plugin = "plugin-4567.so";
  moved.task_file = "/home/me/tasks/crawling.task";
  EXPECT_TRUE(IsSameVersion(SampleTask(), moved));
  moved.compiler = "taskc 0.2.0";
  EXPECT_FALSE(IsSameVersion(SampleTask(), moved));
  TaskRecord by_hand = SampleTask();
  TaskRecord other = moved;
  by_hand.task_hash = other.task_hash = "";
  other.compiler = by_hand.compiler;
  EXPECT_FALSE(IsSameVersion(by_hand, other));
}

}  // namespace
}  // namespace runtime
