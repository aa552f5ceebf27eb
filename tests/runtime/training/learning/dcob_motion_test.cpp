#include "runtime/training/learning/dcob_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/training/learning/random.h"
#include "tests/runtime/training/learning/time_step.h"

namespace runtime {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

int TimeSteps(DcobMotion& motion) {
  int steps = 0;
  do {
    motion.Command();
    ++steps;
  } while (!motion.Advance(kTimeStep));
  return steps;
}

// T = 0.1 s/rad * 1 rad = 0.1 s; D = sqrt(1.25) = 1.118; T_N = 0.6 / 1.118 * 0.1 s = 0.05367 s.
DcobMotion Example() {
  DcobMotion motion(2);
  const VectorXd start = Vector2d(0.5, 0), target = Vector2d(1.5, -0.5);
  motion.Start(start, target, 0.1, (target - start).norm(), 0.6, 1);
  return motion;
}

TEST(DcobMotion, TakesTheTimesOfTheFormulas) {
  const DcobMotion motion = Example();
  EXPECT_NEAR(motion.full_time(), 0.1, 1e-16);
  EXPECT_NEAR(motion.duration(), 0.05366563145999495, 1e-16);
}

// At 5 ms t/T = 0.05: 1 - 0.95^3 = 0.142625 of the way; at 10 ms 1 - 0.9^3 = 0.271; at 50 ms 0.875.
TEST(DcobMotion, FollowsTheCubic) {
  DcobMotion motion = Example();
  EXPECT_EQ(motion.Command(), Vector2d(0.5, 0));
  motion.Advance(kTimeStep);
  EXPECT_LT((motion.Command() - Vector2d(0.642625, -0.0713125)).norm(), 1e-15);
  motion.Advance(kTimeStep);
  EXPECT_LT((motion.Command() - Vector2d(0.771, -0.1355)).norm(), 1e-15);
  for (int i = 0; i < 8; ++i) motion.Advance(kTimeStep);
  EXPECT_LT((motion.Command() - Vector2d(1.375, -0.4375)).norm(), 1e-15);
}

// floor(0.05367 / 0.005) = 10.
TEST(DcobMotion, IsCutShortWhereTheNextBasisFunctionBegins) {
  DcobMotion motion = Example();
  EXPECT_EQ(TimeSteps(motion), 10);
}

TEST(DcobMotion, FirstCommandIsTheStartToTheLastBit) {
  Random random(1);
  DcobMotion motion(2);
  for (int i = 0; i < 1000; ++i) {
    const VectorXd start = Vector2d(random.Uniform() - 0.5, 3 * random.Uniform());
    const VectorXd target = Vector2d(random.Uniform(), random.Uniform() - 2);
    motion.Start(start, target, 0.1, 1, 0.5, 1);
    ASSERT_EQ(motion.Command(), start);
  }
}

TEST(DcobMotion, LastsTheWholeTimeWhereTheTargetIsNear) {
  DcobMotion motion(2);
  motion.Start(Vector2d(0, 0), Vector2d(0.3, -0.43), 0.2, 0.52, 0.6, 0.5);
  EXPECT_NEAR(motion.duration(), 0.086, 1e-15);  // 0.2 * 0.43: the scale is not applied
  EXPECT_EQ(TimeSteps(motion), 17);              // floor(17.2)
}

TEST(DcobMotion, LastsMaxOfOneAndTheFloorOfTheTime) {
  Random random(2);
  DcobMotion motion(2);
  for (int i = 0; i < 1000; ++i) {
    const VectorXd start = Vector2d(random.Uniform(), random.Uniform());
    const VectorXd target = Vector2d(random.Uniform(), random.Uniform());
    const double way = (target - start).norm();
    motion.Start(start, target, 0.3 * random.Uniform(), way, random.Uniform(), 1);
    const double expected = std::max(1.0, std::floor(motion.duration() / kTimeStep));
    ASSERT_EQ(TimeSteps(motion), expected) << motion.duration();
  }
}

// T = 0.1 * 0.52 = 0.052 s, T_N = 3 * (0.5 / 0.52) * T = 0.15 s: after 11 steps T is used up.
TEST(DcobMotion, NeverLastsLongerThanTheFullMotion) {
  DcobMotion motion(2);
  motion.Start(Vector2d(0, 0), Vector2d(0.52, 0), 0.1, 0.52, 0.5, 3);
  EXPECT_NEAR(motion.duration(), 0.15, 1e-15);
  EXPECT_EQ(TimeSteps(motion), 11);
}

TEST(DcobMotion, HoldsForOneStepWhereStartIsTarget) {
  DcobMotion motion(2);
  const VectorXd here = Vector2d(0.1, 0.7);
  for (const double distance : {0.0, 5.0}) {  // 5: from elements of the state that do not move
    motion.Start(here, here, 0.1, distance, 1.5, 1);
    EXPECT_EQ(motion.Command(), here);
    EXPECT_TRUE(motion.Advance(kTimeStep));
    EXPECT_EQ(motion.Command(), here);
  }
}

TEST(DcobMotion, EndsWhereATimeIsNotANumber) {
  DcobMotion motion(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  motion.Start(Vector2d(nan, 0), Vector2d(1, 1), 0.1, nan, 1, 1);
  EXPECT_TRUE(motion.Advance(kTimeStep));
}

TEST(DcobMotion, StartsAnew) {
  DcobMotion motion = Example();
  TimeSteps(motion);
  const VectorXd start = Vector2d(2, 2), target = Vector2d(0.97, 2);
  motion.Start(start, target, 0.1, 1.03, 1.5, 1);
  EXPECT_EQ(motion.Command(), start);
  EXPECT_EQ(TimeSteps(motion), 20);  // floor(0.103 / 0.005)
}

}  // namespace
}  // namespace runtime
