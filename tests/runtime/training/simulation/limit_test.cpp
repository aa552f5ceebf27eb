#include "runtime/training/simulation/limit.h"

#include <gtest/gtest.h>

namespace runtime {
namespace {

using State = LimitedPull::State;

LimitedPull Pull(State state) {
  return {.target = 2, .stiffness = 0.5, .low = -1, .high = 1, .state = state};
}

TEST(LimitedPull, PullsAsASpringBetweenItsLimits) {
  const LimitedPull pull = Pull(State::kSpring);
  EXPECT_EQ(pull.load() - pull.hold() * 1.5, pull.Wanted(1.5));
  EXPECT_EQ(pull.Wanted(1.5), 0.25);
  EXPECT_EQ(pull.NextState(1.5), State::kSpring);
}

TEST(LimitedPull, PushesWithTheLimitBeyondIt) {
  EXPECT_EQ(Pull(State::kLow).load(), -1);
  EXPECT_EQ(Pull(State::kHigh).load(), 1);
  EXPECT_EQ(Pull(State::kLow).hold(), 0);
  EXPECT_EQ(Pull(State::kSpring).NextState(4.5), State::kLow);
  EXPECT_EQ(Pull(State::kSpring).NextState(-0.5), State::kHigh);
}

TEST(LimitedPull, GoesFromOneLimitToTheOtherByTheSpring) {
  EXPECT_EQ(Pull(State::kLow).NextState(-5), State::kSpring);
  EXPECT_EQ(Pull(State::kHigh).NextState(9), State::kSpring);
  EXPECT_EQ(Pull(State::kLow).NextState(9), State::kLow);
}

TEST(LimitedPull, RoundingAtALimitChangesNothing) {
  const double at_low = 4;
  for (const State state : {State::kLow, State::kSpring}) {
    EXPECT_EQ(Pull(state).NextState(at_low + 1e-14), state);
    EXPECT_EQ(Pull(state).NextState(at_low - 1e-14), state);
  }
}

TEST(LimitedPull, OneThatIsNotSetDoesNothing) {
  const LimitedPull none;
  EXPECT_EQ(none.load(), 0);
  EXPECT_EQ(none.hold(), 0);
  EXPECT_EQ(none.NextState(3), State::kSpring);
}

}  // namespace
}  // namespace runtime
