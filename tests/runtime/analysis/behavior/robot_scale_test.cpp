#include "runtime/analysis/behavior/robot_scale.h"

#include <gtest/gtest.h>

#include <numbers>

namespace runtime {
namespace {

// All lengths times `factor`; boxes, capsules and spheres.
robot::RobotDescription Humanoid(double factor) {
  robot::RobotDescription robot = robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  const auto enlarge = [&](robot::Vector3& vector) {
    for (double& element : vector) element *= factor;
  };
  for (robot::Link& link : robot.links) {
    enlarge(link.position);
    enlarge(link.shape.size);
    link.shape.radius *= factor;
    link.shape.length *= factor;
  }
  for (robot::Joint& joint : robot.joints) enlarge(joint.anchor);
  for (robot::Pose& pose : robot.poses) enlarge(pose.position);
  return robot;
}

// What was found of its runs stays as it is, to the last bit.
TEST(ScaleOf, IsOneForTheHumanoid) { EXPECT_EQ(ScaleOf(Humanoid(1)), 1); }

TEST(ScaleOf, GrowsWithTheRobot) {
  EXPECT_NEAR(ScaleOf(Humanoid(5)), 5, 0.03);
  EXPECT_NEAR(ScaleOf(Humanoid(0.25)), 0.25, 0.01);
  EXPECT_EQ(ScaleOf(Humanoid(1e-6)), 0.01);
}

// A box of 0.3 m x 0.4 m x 1.2 m: its diagonal is 1.3 m, however it stands.
TEST(ScaleOf, TakesTheDiagonalOfTheBoxAroundAllShapes) {
  robot::RobotDescription robot;
  robot::Link& link = robot.links.emplace_back();
  link.shape.kind = robot::ShapeKind::kBox;
  link.shape.size = {0.3, 0.4, 1.2};
  const double half = std::numbers::sqrt2 / 2;
  for (const robot::Quaternion& turn : {robot::Quaternion{1, 0, 0, 0}, {half, half, 0, 0}}) {
    robot.poses = {{"lying", {7, 8, 9}, turn, {}}};
    EXPECT_EQ(ScaleOf(robot), 3.33);
  }
}

// The rail of the cart-pole is no part of what moves.
TEST(ScaleOf, LeavesOutAFixedBase) {
  robot::RobotDescription robot = robot::ReadRobot(SOURCE_DIR "/plugins/cart_pole/robot.toml");
  const double scale = ScaleOf(robot);
  robot.links.front().shape.size = {100, 100, 100};
  EXPECT_EQ(ScaleOf(robot), scale);
}

}  // namespace
}  // namespace runtime
