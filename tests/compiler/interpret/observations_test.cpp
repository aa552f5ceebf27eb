// What the learner sees, as the evaluator computes it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/interpret/evaluator.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::ElementsAre;

TEST(Observations, StandOneAfterTheOtherInTheirOrder) {
  const CheckedTask task = CheckTask(
      "task seeing\nsensor place: vec2 [m]\nsensor touches: bool[3]\nmemory steps: int = 7\n"
      "observe touches\nobserve half = 0.5 * place\nobserve steps\n"
      "on end_of_time_step { steps += 1 reward a = place.x / 1 m + count(touches) }\n");
  Evaluator evaluator(task);
  evaluator.frame().sensors[0] = Reals{3, 4};
  evaluator.frame().sensors[1] = Integers{0, 1, 0};
  evaluator.Observe();
  EXPECT_THAT(evaluator.frame().observations, ElementsAre(0, 1, 0, 1.5, 2, 7));
  evaluator.Fire(EventKind::kEndOfTimeStep, 0.1);
  EXPECT_THAT(evaluator.frame().observations, ElementsAre(0, 1, 0, 1.5, 2, 7));
  evaluator.Observe();
  EXPECT_THAT(evaluator.frame().observations, ElementsAre(0, 1, 0, 1.5, 2, 8));
}

TEST(Observations, GoOnAfterAnEnd) {
  const CheckedTask task = CheckTask(
      "task seeing\nsensor x: real\nobserve x\nobserve past = previous(x)\n"
      "on end_of_time_step { reward a = x end_episode success \"done\" }\n");
  Evaluator evaluator(task);
  const auto step_with = [&](double x) {
    evaluator.frame().sensors[0] = Reals{x};
    evaluator.Fire(EventKind::kEndOfTimeStep, 0.1);
    evaluator.Observe();
  };
  evaluator.Fire(EventKind::kStartOfEpisode, 0);
  step_with(2);
  EXPECT_THAT(evaluator.frame().observations, ElementsAre(2, 0));
  step_with(3);  // memory stays as it is
  EXPECT_THAT(evaluator.frame().observations, ElementsAre(3, 0));
}

}  // namespace
}  // namespace compiler
