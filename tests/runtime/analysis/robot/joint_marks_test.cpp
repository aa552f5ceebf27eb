#include "runtime/analysis/robot/joint_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace runtime {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kSize = 10;  // of the robot: arcs are at most 0.7 m then
constexpr uint32_t kGreen = 0x2f9e44;

// A link of 1 m hangs below the base on a hinge along y.
robot::RobotDescription Pendulum() {
  robot::RobotDescription robot;
  robot.links = {{"base", 1, {0, 0, 0}, {}}, {"rod", 1, {0, 0, -1}, {}}};
  robot.joints = {{"hinge", 0, 1, {0, 1, 0}, {0, 0, 0}, -kPi / 2, kPi / 4}};
  robot.poses = {{"start", {0, 0, 5}, {1, 0, 0, 0}, {0}}};
  return robot;
}

std::vector<Stroke> MarksOf(const robot::RobotDescription& robot) {
  return JointMarks(robot, LinkFrames(robot, robot.poses.front()), kSize);
}

bool HasEnd(const std::vector<Stroke>& strokes, const Vector3d& place) {
  return std::ranges::any_of(strokes, [&](const Stroke& stroke) {
    return (stroke.from - place).norm() < 1e-9 || (stroke.to - place).norm() < 1e-9;
  });
}

TEST(JointMarks, AnArrowLiesAlongTheAxis) {
  const std::vector<Stroke> strokes = MarksOf(Pendulum());
  EXPECT_TRUE(strokes.front().from.isApprox(Vector3d(0, -0.7, 5)));
  EXPECT_TRUE(strokes.front().to.isApprox(Vector3d(0, 0.7, 5)));
  for (const Stroke& stroke : strokes) EXPECT_EQ(stroke.color, kGreen);  // along y
}

// A positive angle turns by minus the angle about +y: what hangs below goes forward.
TEST(JointMarks, TheArcGoesFromTheLowerStopToTheUpperOne) {
  const std::vector<Stroke> strokes = MarksOf(Pendulum());
  const double aside = 0.7 * std::sqrt(0.5);
  EXPECT_TRUE(HasEnd(strokes, Vector3d(-0.7, 0, 5)));
  EXPECT_TRUE(HasEnd(strokes, Vector3d(aside, 0, 5 - aside)));
  EXPECT_FALSE(HasEnd(strokes, Vector3d(0.7, 0, 5)));
}

TEST(JointMarks, TheHandPointsWhereTheJointIs) {
  robot::RobotDescription robot = Pendulum();
  EXPECT_TRUE(MarksOf(robot).back().to.isApprox(Vector3d(0, 0, 4.3)));
  robot.poses[0].joint_angles = {-kPi / 2};
  EXPECT_TRUE(MarksOf(robot).back().to.isApprox(Vector3d(-0.7, 0, 5)));
}

TEST(JointMarks, WithoutStopsTheArcIsAWholeTurn) {
  robot::RobotDescription robot = Pendulum();
  robot.joints[0].kind = robot::JointKind::kContinuous;
  robot.joints[0].low = -robot::kUnlimited;
  robot.joints[0].high = robot::kUnlimited;
  const std::vector<Stroke> strokes = MarksOf(robot);
  for (const Vector3d& way : {Vector3d(0.7, 0, 0), Vector3d(-0.7, 0, 0), Vector3d(0, 0, 0.7)}) {
    EXPECT_TRUE(HasEnd(strokes, Vector3d(0, 0, 5) + way));
  }
}

TEST(JointMarks, ASliderIsAsLongAsItsTravel) {
  robot::RobotDescription robot = Pendulum();
  robot::Joint& slider = robot.joints[0];
  slider.kind = robot::JointKind::kSlider;
  slider.radius = 0.5;
  slider.low = -4;
  slider.high = 6;
  robot.poses[0].joint_angles = {2};
  const std::vector<Stroke> strokes = MarksOf(robot);
  EXPECT_TRUE(strokes.front().from.isApprox(Vector3d(0, -2, 4)));
  EXPECT_TRUE(strokes.front().to.isApprox(Vector3d(0, 3, 4)));
  const Vector3d hand = 0.5 * (strokes.back().from + strokes.back().to);
  EXPECT_TRUE(hand.isApprox(Vector3d(0, 1, 4)));
}

}  // namespace
}  // namespace runtime
