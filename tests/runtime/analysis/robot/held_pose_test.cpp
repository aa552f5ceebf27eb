#include "runtime/analysis/robot/held_pose.h"

#include <gmock/gmock.h>

#include "runtime/training/simulation/collision.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

TEST(HeldPose, TheHumanoidStandsInEveryProfile) {
  const robot::RobotDescription robot = Humanoid();
  for (const Profile& profile : kProfiles) {
    if (!profile.IsBuilt()) continue;
    const HeldPose held = HoldPose(robot, profile, *robot.FindPose("standing"));
    EXPECT_TRUE(held.Stands()) << profile.name;
    EXPECT_LT(held.tilt, 0.02) << profile.name;
    EXPECT_LT(held.drift, 0.005) << profile.name;
    EXPECT_LT(held.chatter, 0.2) << profile.name;
    EXPECT_NEAR(held.seconds, 1, 1e-9);
    EXPECT_GT(held.real_time_factor, 0.1);
    EXPECT_GT(held.size, 0.3);
  }
}

TEST(HeldPose, WhatTopplesFalls) {
  robot::RobotDescription robot = Hopper();
  robot.poses[0].orientation = {0.98, 0.2, 0, 0};
  const HeldPose held = HoldPose(robot, FindProfile("fast-tree"), robot.poses[0], 2);
  EXPECT_FALSE(held.Stands());
  EXPECT_EQ(held.failure, "");
}

TEST(HeldPose, SeesWhatIsInTheGround) {
  robot::RobotDescription robot = Humanoid();
  robot::Pose pose = *robot.FindPose("standing");
  pose.position[2] -= 0.02;
  const HeldPose held = HoldPose(robot, FindProfile("fast-tree"), pose, 0.01);
  ASSERT_FALSE(held.overlaps.empty());
  EXPECT_EQ(held.overlaps[0].first, Contact::kGround);
  EXPECT_NEAR(held.overlaps[0].depth, 0.02, 0.003);
}

TEST(HeldPose, AFixedBaseStaysWhereItIs) {
  robot::RobotDescription robot = Hopper();
  robot.has_fixed_base = true;
  const HeldPose held = HoldPose(robot, FindProfile("fast-tree"), robot.poses[0]);
  EXPECT_EQ(held.tilt, 0);
  EXPECT_EQ(held.drift, 0);
  EXPECT_EQ(held.sink, 0);
}

TEST(HeldPose, AStiffLightJointShakesInLongStepsOfTorques) {
  robot::RobotDescription robot = Rotor();
  robot.poses[0].position[2] = 1000;
  robot.poses[0].joint_angles[0] = 0.01;
  // Damping that takes away more speed in a step of 0.2 ms than there is.
  robot.controller.damping = 2.05 * 0.4 * 0.5 * 0.08 * 0.08 / 0.0002;
  robot.controller.max_torque = 0.05;
  EXPECT_GT(HoldPose(robot, FindProfile("paper"), robot.poses[0]).chatter, 0.001);
  EXPECT_LT(HoldPose(robot, FindProfile("fast"), robot.poses[0]).chatter, 0.001);
}

TEST(HeldPose, SaysWhyASimulationDiverges) {
  robot::RobotDescription robot = Rotor();
  robot.joints[0].high = 1;
  robot.poses[0].joint_angles[0] = 2;
  const HeldPose held = HoldPose(robot, FindProfile("paper"), robot.poses[0]);
  EXPECT_EQ(held.failure, "the joint axle is far beyond its stop");
  EXPECT_LT(held.seconds, 1);
  EXPECT_FALSE(held.Stands());
  EXPECT_EQ(held.end.size(), 2u);
}

}  // namespace
}  // namespace runtime
