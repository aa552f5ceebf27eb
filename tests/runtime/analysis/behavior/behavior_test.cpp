#include "runtime/analysis/behavior/behavior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace runtime {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kDuration = 10;     // of a motion, unless it says otherwise [s]
constexpr double kTolerance = 1e-6;  // postures are floats

// A body and a foot, both spheres of 0.1 m radius, times the scale.
std::vector<robot::Link> Links(double scale) {
  robot::Link body;
  body.shape = {robot::ShapeKind::kSphere, {}, 0.1 * scale, 0, 2};
  return {body, body};
}

// Where the two are at a time [s]; the body stands still at a height of 1 m, the foot is lifted.
struct Script {
  std::function<Vector3d(double)> body = [](double) { return Vector3d(0, 0, 1); };
  std::function<Quaterniond(double)> body_turn = [](double) { return Quaterniond::Identity(); };
  std::function<double(double)> foot_height = [](double) { return 0.5; };
  std::function<double(double)> foot_angle = [](double) { return 0.; };  // to the body [rad]
  double duration = kDuration;
};

// Of a robot so many times as large, which does the same as slowly as gravity has it.
Behavior BehaviorOf(const Script& script, double scale = 1) {
  constexpr double kInterval = 0.02;  // [s]
  Motion motion{kInterval * std::sqrt(scale), 2, {}, {}};
  const auto frames = std::lround(script.duration / kInterval) + 1;
  for (long frame = 0; frame < frames; ++frame) {
    const double time = kInterval * static_cast<double>(frame);
    const Quaterniond turn = script.body_turn(time);
    motion.positions.push_back(scale * script.body(time));
    motion.orientations.push_back(turn);
    motion.positions.emplace_back(0, 0, scale * script.foot_height(time));
    motion.orientations.push_back(turn * AngleAxisd(script.foot_angle(time), Vector3d::UnitX()));
  }
  return DescribeBehavior(motion, Links(scale), scale);
}

Script Walk(double speed) {
  Script script;
  script.body = [=](double time) { return Vector3d(speed * time, 0, 1); };
  return script;
}

Script Roll(double turns) {
  Script script;
  script.body_turn = [=](double time) {
    return Quaterniond(AngleAxisd(2 * kPi * turns * time / kDuration, Vector3d::UnitY()));
  };
  return script;
}

// The foot comes down `steps` times and is on the floor half of the time.
Script Steps(double steps, double phase = 0) {
  Script script;
  const double frequency = steps / kDuration;
  script.foot_height = [=](double time) {
    return 0.15 - 0.05 * std::copysign(1., std::sin(2 * kPi * (frequency * time + phase) - 1e-3));
  };
  return script;
}

Script Swing(double frequency, double phase) {
  Script script;
  script.foot_angle = [=](double time) { return std::sin(2 * kPi * (frequency * time + phase)); };
  return script;
}

TEST(DescribeBehavior, MeasuresTheVelocityFromWhereTheBaseFaces) {
  Script script = Walk(0.5);
  EXPECT_TRUE(BehaviorOf(script).velocity.isApprox(Vector2d(0.5, 0)));
  script.body_turn = [](double) { return Quaterniond(AngleAxisd(kPi / 2, Vector3d::UnitZ())); };
  EXPECT_TRUE(BehaviorOf(script).velocity.isApprox(Vector2d(0, -0.5)));  // it faces +y
}

TEST(DescribeBehavior, CountsFullTurnsAboutTheAxesOfTheBase) {
  EXPECT_TRUE(BehaviorOf(Roll(3)).turns.isApprox(Vector3d(0, 3, 0), 1e-9));
  EXPECT_TRUE(BehaviorOf(Roll(-1.5)).turns.isApprox(Vector3d(0, -1.5, 0), 1e-9));
}

TEST(DescribeBehavior, SortsHeightsAndTilts) {
  Script script = Roll(0.5);  // from upright to upside down
  script.body = [](double time) { return Vector3d(0, 0, 2 - time / kDuration); };  // 2 ... 1 m
  const Behavior behavior = BehaviorOf(script);
  EXPECT_NEAR(behavior.heights[0], 1.025, 0.003);  // middle of the lowest twentieth
  EXPECT_NEAR(behavior.heights[19], 1.975, 0.003);
  EXPECT_NEAR(behavior.tilts[0], std::cos(kPi * 0.975), 0.003);
  EXPECT_NEAR(behavior.tilts[19], std::cos(kPi * 0.025), 0.003);
}

TEST(DescribeBehavior, CountsTouchdownsAndTheTimeOnTheFloor) {
  const Behavior behavior = BehaviorOf(Steps(5));
  EXPECT_DOUBLE_EQ(behavior.contact_shares[0], 0);  // the body
  EXPECT_NEAR(behavior.contact_shares[1], 0.5, 0.01);
  EXPECT_DOUBLE_EQ(behavior.touchdowns[1], 5 / kDuration);
}

// Over in half a second, with one touchdown: as in a whole second, not two of them in one.
TEST(DescribeBehavior, CountsTouchdownsInASecondAtLeast) {
  Script script;
  script.duration = 0.5;
  script.foot_height = [](double time) { return time < 0.25 ? 0.2 : 0.1; };
  EXPECT_DOUBLE_EQ(BehaviorOf(script).touchdowns[1], 1);
}

TEST(DescribeBehavior, AFootThatTremblesAboveTheFloorIsStillDown) {
  Script script;
  script.foot_height = [](double time) { return 0.105 + 0.01 * std::sin(20 * time); };
  const Behavior behavior = BehaviorOf(script);
  EXPECT_NEAR(behavior.contact_shares[1], 1, 0.03);
  EXPECT_LE(behavior.touchdowns[1] * kDuration, 1);
}

TEST(DescribeBehavior, ARecordingOfOneFrameIsAtRest) {
  Script script = Walk(1);
  script.duration = 0;
  const Behavior behavior = BehaviorOf(script);
  EXPECT_EQ(behavior.velocity, Vector2d(0, 0));
  EXPECT_EQ(behavior.turns, Vector3d(0, 0, 0));
}

TEST(DescribeBehavior, IsThatOfTheSmallRobotForALargeOneThatMovesAlike) {
  for (const Script& script : {Walk(0.3), Roll(2), Steps(7), Swing(0.5, 0)}) {
    const Behavior small = BehaviorOf(script);
    const Behavior large = BehaviorOf(script, 4);
    EXPECT_TRUE(large.velocity.isApprox(small.velocity, kTolerance));
    EXPECT_TRUE(large.heights.isApprox(small.heights, kTolerance));
    EXPECT_EQ(large.contact_shares, small.contact_shares);
    EXPECT_TRUE(large.touchdowns.isApprox(small.touchdowns, kTolerance));
    EXPECT_LT(DistanceBetween(large, small).total(), 2e-3);  // postures are floats
  }
}

TEST(DistanceBetween, IsZeroForTheSame) {
  const Behavior walk = BehaviorOf(Walk(0.3));
  EXPECT_NEAR(DistanceBetween(walk, walk).total(), 0, 2e-3);  // postures are floats
}

TEST(DistanceBetween, IsOneForEachScale) {
  const Behavior still = BehaviorOf({});
  EXPECT_NEAR(DistanceBetween(still, BehaviorOf(Walk(0.15))).base, 1, kTolerance);
  Script higher;
  higher.body = [](double) { return Vector3d(0, 0, 1.1); };
  EXPECT_NEAR(DistanceBetween(still, BehaviorOf(higher)).base, 1, kTolerance);
  EXPECT_NEAR(DistanceBetween(BehaviorOf(Steps(4)), BehaviorOf(Steps(14))).contacts, 1, 0.02);
  Script lying;  // a tilt of 0 rather than 1: two scales
  lying.body_turn = [](double) { return Quaterniond(AngleAxisd(kPi / 2, Vector3d::UnitX())); };
  EXPECT_NEAR(DistanceBetween(still, BehaviorOf(lying)).base, 2, kTolerance);
}

TEST(DistanceBetween, TakesPosturesByTheChordOfTheirAngle) {
  Script bent;
  bent.foot_angle = [](double) { return kPi / 2; };
  const BehaviorDistance distance = DistanceBetween(BehaviorOf({}), BehaviorOf(bent));
  EXPECT_NEAR(distance.joints, 2 * std::sin(kPi / 4) / 0.5, kTolerance);
  EXPECT_EQ(distance.base, 0);
  EXPECT_EQ(distance.contacts, 0);
}

TEST(DistanceBetween, DoesNotSeeWhichStepWasFirst) {
  EXPECT_LT(DistanceBetween(BehaviorOf(Swing(1, 0)), BehaviorOf(Swing(1, 0.5))).total(), 0.1);
  EXPECT_LT(DistanceBetween(BehaviorOf(Steps(10)), BehaviorOf(Steps(10, 0.5))).total(), 0.15);
}

TEST(DistanceBetween, DoesNotSeeHowLongAGaitWasWatched) {
  Script longer = Walk(0.3);
  longer.duration = 2 * kDuration;
  EXPECT_LT(DistanceBetween(BehaviorOf(Walk(0.3)), BehaviorOf(longer)).total(), 0.01);
}

TEST(DistanceBetween, TellsOneRollFromTwo) {
  EXPECT_GT(DistanceBetween(BehaviorOf(Roll(1)), BehaviorOf(Roll(2))).base, 1.3);
  EXPECT_GT(DistanceBetween(BehaviorOf(Roll(1)), BehaviorOf(Roll(-1))).base, 2.6);
}

TEST(DistanceBetween, IsSymmetric) {
  const Behavior a = BehaviorOf(Swing(0.1, 0));
  const Behavior b = BehaviorOf(Steps(3));
  EXPECT_DOUBLE_EQ(DistanceBetween(a, b).total(), DistanceBetween(b, a).total());
}

TEST(BehaviorDistance, AddsItsPartsAsRightAngles) {
  EXPECT_DOUBLE_EQ((BehaviorDistance{2, 3, 6}.total()), 7);
}

}  // namespace
}  // namespace runtime
