#include "runtime/training/learning/parametric_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/training/learning/vector_of.h"

namespace runtime {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kPi = std::numbers::pi;

// Two coordinates, from -1 to 3 and from -0.5 to 0.5.
ParametricMotion Motion(const ParametricMotion::Settings& settings) {
  return ParametricMotion(settings, Vector2d(1, 0), Vector2d(2, 0.5));
}

// 1 + 2 (0.25 + 0.5 sin(4 pi t) + 0.1 cos(8 pi t) / 2), 0.5 cos(4 pi t): 2 Hz is in the middle
// between 1 and 4.
TEST(ParametricMotion, IsPeriodic) {
  ParametricMotion motion = Motion({.harmonics = 2, .lowest_frequency = 1, .highest_frequency = 4});
  ASSERT_EQ(motion.size(), 11);
  motion.Take(VectorOf({0, 0.25, 0.5, 0, 0, 0.1, 0, 0, 1, 0, 0}), Vector2d(1, 0));
  EXPECT_DOUBLE_EQ(motion.frequency(), 2);
  EXPECT_NEAR(motion.At(0)[0], 1.6, 1e-14);
  EXPECT_NEAR(motion.At(0.03)[0], 1.5 + std::sin(4 * kPi * 0.03) + 0.1 * std::cos(8 * kPi * 0.03),
              1e-14);
  EXPECT_NEAR(motion.At(0.03)[1], 0.5 * std::cos(4 * kPi * 0.03), 1e-14);
  EXPECT_LT((motion.At(7.53) - VectorXd(motion.At(0.03))).norm(), 1e-12);
}

TEST(ParametricMotion, FrequencyGrowsByEqualFactors) {
  ParametricMotion motion =
      Motion({.harmonics = 1, .lowest_frequency = 0.5, .highest_frequency = 8});
  const auto frequency = [&](double parameter) {
    VectorXd parameters = VectorXd::Zero(motion.size());
    parameters[0] = parameter;
    motion.Take(parameters, Vector2d::Zero());
    return motion.frequency();
  };
  EXPECT_DOUBLE_EQ(frequency(-1), 0.5);
  EXPECT_DOUBLE_EQ(frequency(-0.5), 1);
  EXPECT_DOUBLE_EQ(frequency(0), 2);
  EXPECT_DOUBLE_EQ(frequency(1), 8);
}

// Two knots in 0.5 s, at -1 + 4 (1 + u) / 2.
TEST(ParametricMotion, GoesThroughItsKnotsOnce) {
  ParametricMotion motion =
      Motion({.kind = "one_shot", .knots = 2, .lowest_frequency = 2, .highest_frequency = 2});
  ASSERT_EQ(motion.size(), 5);
  motion.Take(VectorOf({0, 0.5, 1, 0, 0}), Vector2d(0.2, 0));
  EXPECT_NEAR(motion.At(0)[0], 0.2, 1e-14);
  EXPECT_NEAR(motion.At(0.25)[0], 2, 1e-14);
  EXPECT_NEAR(motion.At(0.5)[0], 3, 1e-14);
  EXPECT_NEAR(motion.At(9)[0], 3, 1e-14);
  EXPECT_EQ(motion.At(0.4)[1], 0);
  // Rates: 0 at both ends, at the knot between them (3 - 0.2) / 0.5.
  const auto rate = [&](double time) {
    return (motion.At(time + 1e-7)[0] - motion.At(time - 1e-7)[0]) / 2e-7;
  };
  EXPECT_NEAR(rate(1e-7), 0, 1e-4);
  EXPECT_NEAR(rate(0.25), 5.6, 1e-4);
  EXPECT_NEAR(rate(0.5 - 1e-7), 0, 1e-4);
}

TEST(ParametricMotion, StandsStillWhereItRests) {
  for (const char* kind : {"periodic", "one_shot"}) {
    ParametricMotion motion = Motion({.kind = kind});
    const Vector2d rest(0.3, -0.4);
    const VectorXd standstill = motion.Standstill(rest);
    ASSERT_EQ(standstill.size(), motion.size());
    motion.Take(standstill, rest);
    for (const double time : {0.0, 0.123, 0.7, 5.0}) {
      EXPECT_LT((motion.At(time) - rest).norm(), 1e-14) << kind << " " << time;
    }
    EXPECT_EQ(motion.Standstill(Vector2d(9, 0)).maxCoeff(), 1);  // cannot get there
  }
}

}  // namespace
}  // namespace runtime
