#include "base/text/nearest_name.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace text {
namespace {

TEST(SpellingDistance, CountsEachKindOfMistakeOnce) {
  EXPECT_EQ(SpellingDistance("reward", "reward"), 0u);
  EXPECT_EQ(SpellingDistance("rewrd", "reward"), 1u);    // missing
  EXPECT_EQ(SpellingDistance("rewaard", "reward"), 1u);  // additional
  EXPECT_EQ(SpellingDistance("rexard", "reward"), 1u);   // wrong
  EXPECT_EQ(SpellingDistance("rewadr", "reward"), 1u);   // swapped
  EXPECT_EQ(SpellingDistance("", "abc"), 3u);
  EXPECT_EQ(SpellingDistance("abc", ""), 3u);
  EXPECT_EQ(SpellingDistance("kitten", "sitting"), 3u);
}

TEST(SpellingDistance, CaseDoesNotCount) { EXPECT_EQ(SpellingDistance("Reward", "reWARD"), 0u); }

TEST(DottedDistance, CountsTheMistakesOfAllParts) {
  EXPECT_EQ(DottedDistance("bas.velocty", "base.velocity"), 2u);
  EXPECT_EQ(DottedDistance("time", "time"), 0u);
}

TEST(DottedDistance, IsNoneWhereAPartIsAnotherWord) {
  EXPECT_EQ(DottedDistance("body.velocity", "base.velocity"), std::nullopt);
  EXPECT_EQ(DottedDistance("base.speed", "base.velocity"), std::nullopt);
}

TEST(DottedDistance, IsNoneWhereThePartsAreNotAsMany) {
  EXPECT_EQ(DottedDistance("base", "base.velocity"), std::nullopt);
  EXPECT_EQ(DottedDistance("base.velocity.x", "base.velocity"), std::nullopt);
}

TEST(NearestName, TheNearestOfSeveralWins) {
  const std::vector<std::string> names = {"base.position", "base.velocity", "joint.velocity"};
  EXPECT_EQ(NearestName("base.velocty", names), "base.velocity");
}

TEST(NearestName, TheFirstOfEquallyNearOnesWins) {
  EXPECT_EQ(NearestName("fool", std::vector<std::string>{"foot", "food"}), "foot");
}

TEST(NearestName, AnotherWordIsNoMisspelling) {
  const std::vector<std::string> names = {"crawling", "turning"};
  EXPECT_EQ(NearestName("walk", names), std::nullopt);
  EXPECT_EQ(NearestName("t", std::vector<std::string>{"s"}), std::nullopt);
  EXPECT_EQ(NearestName("", names), std::nullopt);
}

TEST(NearestName, AThirdOfTheNameMayBeWrong) {
  const std::vector<std::string> names = {"left_foot"};
  EXPECT_EQ(NearestName("lept_fuut", names), "left_foot");
  EXPECT_EQ(NearestName("lopt_fuut", names), std::nullopt);
}

TEST(NearestName, TakesAnyRangeOfStrings) {
  constexpr std::string_view kNames[] = {"head", "body"};
  EXPECT_EQ(NearestName("haed", kNames), "head");
}

}  // namespace
}  // namespace text
