#include "runtime/analysis/preference/contradictions.h"

#include <gmock/gmock.h>

#include "tests/runtime/analysis/preference/over.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Preference Tie(const char* one, const char* other) {
  return {ParseBehaviorName(one), ParseBehaviorName(other), true};
}

TEST(FindContradictions, ThereAreNoneInAnOrder) {
  EXPECT_THAT(FindContradictions({Over("a", "b"), Over("b", "c"), Over("a", "c"), Tie("c", "d")}),
              IsEmpty());
}

TEST(FindContradictions, AreWhatIsBetterThanItself) {
  EXPECT_THAT(FindContradictions({Over("a", "b"), Over("c", "d"), Over("b", "a")}),
              ElementsAre(0, 2));
  EXPECT_THAT(FindContradictions({Over("a", "b"), Over("x", "a"), Over("b", "c"), Over("c", "a")}),
              ElementsAre(0, 2, 3));
}

TEST(FindContradictions, LeadOverEqualOnes) {
  EXPECT_THAT(FindContradictions({Over("a", "b"), Tie("b", "c"), Tie("a", "c")}), ElementsAre(0));
}

TEST(FindContradictions, EpisodesOfARunAreBehaviorsOfTheirOwn) {
  EXPECT_THAT(FindContradictions({Over("a", "b"), Over("b:7", "a")}), IsEmpty());
}

}  // namespace
}  // namespace runtime
