#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(Diff, HasTheStatusOfDiff) {
  TaskcProcess taskc;
  taskc.Write("a.task", kGoodTask);
  taskc.Write("b.task", "// The same.\n" + std::string(kGoodTask));
  Outcome outcome = taskc.Run("diff a.task b.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.error, "");
  std::string other = kGoodTask;
  other.replace(other.find("2 s"), 3, "3 s");
  taskc.Write("b.task", other);
  outcome = taskc.Run("diff a.task b.task");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("  + end_of_time_step: if time > 3 s: ends\n"));
}

TEST(Diff, SaysWhatIsWrongWithATask) {
  TaskcProcess taskc;
  taskc.Write("a.task", kGoodTask);
  taskc.Write("b.task", "task b for humanoid\nmetric way = nothing_like_it\n");
  const Outcome outcome = taskc.Run("diff a.task b.task");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error, HasSubstr("b.task:2:14"));
  EXPECT_EQ(taskc.Run("diff a.task absent.task").status, 2);
  EXPECT_EQ(taskc.Run("diff a.task").status, 2);
}

TEST(Diff, IsDataToo) {
  TaskcProcess taskc;
  taskc.Write("a.task", kGoodTask + std::string("metric way = base.position.x\n"));
  taskc.Write("b.task", kGoodTask + std::string("metric sum way = base.position.x\n"));
  const Json json = Json::parse(taskc.Run("diff --json a.task b.task").out);
  EXPECT_EQ(json["same"], false);
  ASSERT_EQ(json["changes"].size(), 1u);
  EXPECT_EQ(json["changes"][0]["kind"], "changed");
  EXPECT_EQ(json["changes"][0]["part"], "metric");
  EXPECT_EQ(json["changes"][0]["name"], "way");
  EXPECT_EQ(json["changes"][0]["what"], "of an episode");
  EXPECT_EQ(json["changes"][0]["before"], "last");
  EXPECT_EQ(json["changes"][0]["after"], "sum");
}

}  // namespace
}  // namespace compiler
