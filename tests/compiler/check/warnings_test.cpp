// Where the checker must stay silent. What it warns of is in messages/warn_*.task.
#include "compiler/check/warnings.h"

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

std::string WarningsOf(const std::string& declarations, const std::string& block) {
  const CheckedSource checked(
      TaskText(declarations, "if time > 20 s { truncate_episode \"time is up\" }\n" + block));
  EXPECT_TRUE(checked.task);
  return checked.Messages();
}

TEST(Warnings, AreNotGivenForMemoryThatOnlyAMetricReads) {
  EXPECT_EQ(WarningsOf("memory waited: real [s] = 0\nmetric wait = waited", "waited += time_step"),
            "");
}

TEST(Warnings, AreNotGivenForParamsThatOnlyAMemoryStartsWith) {
  EXPECT_EQ(WarningsOf("param first: real = 1\nmemory left: real = first",
                       "left -= 1\nif left < 0 { left = 3 }"),
            "");
}

TEST(Warnings, AreNotGivenForRewardsUnderACondition) {
  EXPECT_EQ(WarningsOf("", "if contact[head] { reward fall = -4 }"), "");
}

TEST(Warnings, AreNotGivenForRates) {
  EXPECT_EQ(WarningsOf("", "reward rate forward = base.velocity.x"), "");
}

TEST(Warnings, AreNotGivenForRewardsOfAnAction) {
  const CheckedSource checked(
      "task paid for humanoid\non end_of_action {\n  reward effort = -1\n"
      "  if time > 1 s { truncate_episode \"late\" }\n}\n");
  EXPECT_EQ(checked.Messages(), "");
}

}  // namespace
}  // namespace compiler
