// When a potential pays, and how much.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compiler/interpret/evaluator.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// A potential that is the sensor x, with a discount of 1/2.
class PotentialRun {
 public:
  explicit PotentialRun(const std::string& rest = "")
      : task_(CheckTask("task tested\nsensor x: real\nreward potential p = x\n" + rest)),
        evaluator_(task_) {
    evaluator_.frame().discount = 0.5;
  }

  // What the event pays with this x.
  double Fire(EventKind event, double x) {
    evaluator_.frame().sensors[0] = Reals{x};
    evaluator_.Fire(event, event == EventKind::kEndOfTimeStep ? 0.25 : 0);
    return evaluator_.frame().reward;
  }
  void Start(double x) {
    EXPECT_EQ(Fire(EventKind::kStartOfEpisode, x), 0);
    EXPECT_EQ(Fire(EventKind::kStartOfAction, x), 0);
  }
  // Pays for the action that is over, and begins another.
  double Act(double x) {
    const double paid = Fire(EventKind::kEndOfAction, x);
    EXPECT_EQ(Fire(EventKind::kStartOfAction, x), 0);
    return paid;
  }
  double End(EndKind outcome, double x) {
    evaluator_.frame().outcome = outcome;
    return Fire(EventKind::kEndOfEpisode, x);
  }
  Frame& frame() { return evaluator_.frame(); }

 private:
  CheckedTask task_;
  Evaluator evaluator_;
};

TEST(Potentials, PayForEachActionByHowMuchTheyHaveGrown) {
  PotentialRun run;
  run.Start(4);
  EXPECT_EQ(run.Act(6), 0.5 * 6 - 4);
  EXPECT_EQ(run.Act(2), 0.5 * 2 - 6);
  EXPECT_EQ(run.frame().terms[0], -6);
}

TEST(Potentials, AreZeroAtATerminalEnd) {
  for (const EndKind end : {EndKind::kSuccess, EndKind::kFailure}) {
    PotentialRun run;
    run.Start(4);
    EXPECT_EQ(run.End(end, 100), -4);
  }
}

TEST(Potentials, CountAtALimit) {
  PotentialRun run;
  run.Start(4);
  EXPECT_EQ(run.End(EndKind::kTruncated, 6), 0.5 * 6 - 4);
}

// The action and the episode are over at once: the action is paid for already.
TEST(Potentials, AnActionThatEndsWithTheEpisodeIsPaidForOnce) {
  for (const EndKind end : {EndKind::kSuccess, EndKind::kFailure}) {
    PotentialRun run;
    run.Start(4);
    const double paid = run.Fire(EventKind::kEndOfAction, 6);
    EXPECT_EQ(paid + run.End(end, 6), -4);
  }
  PotentialRun run;
  run.Start(4);
  EXPECT_EQ(run.Fire(EventKind::kEndOfAction, 6), 0.5 * 6 - 4);
  EXPECT_EQ(run.End(EndKind::kTruncated, 6), 0);
}

// After its end the task does nothing until the episode is over; then the state counts that the
// learner's action has led to.
TEST(Potentials, PayForTheActionInWhichTheTaskEnds) {
  PotentialRun run("on end_of_time_step { if x > 10 { truncate_episode \"far\" } }\n");
  run.Start(4);
  run.Fire(EventKind::kEndOfTimeStep, 12);
  EXPECT_EQ(run.Fire(EventKind::kEndOfAction, 14), 0);
  EXPECT_EQ(run.End(EndKind::kTruncated, 14), 0.5 * 14 - 4);
}

TEST(Potentials, PayTheSameWhereCallbacksGoOnAfterAnEnd) {
  PotentialRun run(
      "after_end continue\non end_of_time_step { if x > 10 { end_episode failure "
      "\"far\" } }\n");
  run.Start(4);
  run.Fire(EventKind::kEndOfTimeStep, 12);
  EXPECT_EQ(run.Fire(EventKind::kEndOfAction, 14) + run.End(EndKind::kFailure, 14), -4);
}

// An end right at the start: the learner may still finish one action, or begin none.
TEST(Potentials, PayForAnEpisodeThatEndsAtItsStart) {
  const std::string end = "on start_of_episode { end_episode failure \"no\" }\n";
  PotentialRun run(end);
  run.Fire(EventKind::kStartOfEpisode, 4);
  run.Fire(EventKind::kStartOfAction, 4);
  EXPECT_EQ(run.Fire(EventKind::kEndOfAction, 14), 0);
  EXPECT_EQ(run.End(EndKind::kFailure, 14), -4);
  PotentialRun none(end);
  none.Fire(EventKind::kStartOfEpisode, 4);
  EXPECT_EQ(none.End(EndKind::kFailure, 4), -4);
}

// What memory per action holds at the end of an action is gone when the next one begins.
TEST(Potentials, TelescopeWhateverTheyRead) {
  PotentialRun run(
      "memory part: real = 0 per action\nreward potential q = part * x\n"
      "on end_of_time_step { part = x }\n");
  run.frame().discount = 1;
  run.Start(1);
  for (const double x : {3.0, 7.0, 2.0}) {
    run.Fire(EventKind::kEndOfTimeStep, x);
    run.Act(x);
  }
  EXPECT_EQ(run.frame().terms[1], 2 * 2);
  run.Fire(EventKind::kEndOfTimeStep, 5);
  run.End(EndKind::kFailure, 5);
  EXPECT_EQ(run.frame().terms[1], 0);
}

// In an episode of any actions, the discounted sum is that of its two ends.
TEST(Potentials, TheDiscountedSumOfAnEpisodeIsThatOfItsEnds) {
  const double discount = 0.9;
  const auto sum = [&](EndKind end, bool with_action) {
    PotentialRun run;
    run.frame().discount = discount;
    run.Start(3);
    double total = 0;
    double power = 1;
    for (const double x : {0.1, -2.0, 7.0, 1e3, 0.3}) {
      total += power * run.Act(x);
      power *= discount;
    }
    if (with_action) total += power * run.Fire(EventKind::kEndOfAction, 11);
    return total + power * run.End(end, 11);
  };
  const double limit = std::pow(discount, 6) * 11;
  for (const bool with_action : {false, true}) {
    EXPECT_NEAR(sum(EndKind::kFailure, with_action), -3, 1e-12);
    EXPECT_NEAR(sum(EndKind::kTruncated, with_action), limit - 3, 1e-12);
  }
}

TEST(Potentials, WhatIsNoNumberIsNotPaidAndReportedOnce) {
  PotentialRun run;
  run.Start(4);
  EXPECT_EQ(run.Fire(EventKind::kEndOfAction, kNotANumber), 0);
  EXPECT_EQ(run.frame().fault, 0);
  // A terminal end does not ask what the state would be worth.
  PotentialRun fallen;
  fallen.Start(4);
  EXPECT_EQ(fallen.End(EndKind::kFailure, kNotANumber), -4);
  EXPECT_EQ(fallen.frame().fault, -1);
}

// As after a swap in the middle of an episode.
TEST(Potentials, PayNothingForAnActionWhoseBeginningIsNotKnown) {
  PotentialRun run;
  EXPECT_EQ(run.Act(5), 0);
  EXPECT_EQ(run.Act(8), 0.5 * 8 - 5);
}

}  // namespace
}  // namespace compiler
