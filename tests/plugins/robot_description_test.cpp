#include "plugins/robot/robot_description.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace robot {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

RobotDescription Hopper() { return ReadRobot(ROBOTS "/hopper/robot.toml"); }

TEST(RobotDescription, KeepsWhatTheFileSays) {
  const RobotDescription robot = Hopper();
  EXPECT_EQ(robot.name, "hopper");
  EXPECT_EQ(robot.doc, "A body on one leg with a hip and a knee.");
  EXPECT_EQ(robot.file, ROBOTS "/hopper/robot.toml");
  ASSERT_EQ(robot.links.size(), 3u);
  EXPECT_EQ(robot.links[0].shape.kind, ShapeKind::kBox);
  EXPECT_THAT(robot.links[0].shape.size, ElementsAre(0.1, 0.2, 0.1));
  EXPECT_EQ(robot.links[1].shape.kind, ShapeKind::kCapsule);
  EXPECT_EQ(robot.links[1].shape.axis, 2);
  EXPECT_EQ(robot.links[1].shape.radius, 0.02);
  EXPECT_EQ(robot.links[1].shape.length, 0.14);
  EXPECT_EQ(robot.links[2].shape.kind, ShapeKind::kSphere);
  EXPECT_EQ(robot.links[2].mass, 0.1);
  EXPECT_THAT(robot.links[2].position, ElementsAre(0, 0, -0.2));
  EXPECT_EQ(robot.controller.stiffness, 20);
  EXPECT_EQ(robot.controller.damping, 0.5);
  EXPECT_EQ(robot.controller.max_torque, 3);
  EXPECT_EQ(robot.controller.max_speed, std::numeric_limits<double>::infinity());
  EXPECT_EQ(robot.controller.time_step, 0.01);
}

TEST(RobotDescription, SitesLieOnLinks) {
  const RobotDescription robot = ReadRobot(ROBOTS "/tinker/robot.toml");
  ASSERT_EQ(robot.sites.size(), 5u);
  EXPECT_EQ(robot.sites[1].name, "hand");
  EXPECT_EQ(robot.sites[1].link, robot.FindLink("arm"));
  EXPECT_THAT(robot.sites[1].position, ElementsAre(0, 0.14, -0.12));
  EXPECT_THAT(robot.sites[1].orientation, ElementsAre(0.5, 0.5, 0.5, 0.5));
  EXPECT_THAT(robot.ArmOf(robot.sites[1]), ElementsAre(0, 0, DoubleEq(-0.07)));
  EXPECT_THAT(robot.sites[2].orientation, ElementsAre(1, 0, 0, 0));
  ASSERT_EQ(robot.site_groups.size(), 3u);
  EXPECT_THAT(robot.site_groups[2].members, ElementsAre(1, 2, 3, 4));
  EXPECT_TRUE(Hopper().sites.empty());
}

TEST(RobotDescription, NamesBecomeIndices) {
  const RobotDescription robot = Hopper();
  ASSERT_EQ(robot.joints.size(), 2u);
  EXPECT_EQ(robot.joints[1].parent, 1);
  EXPECT_EQ(robot.joints[1].child, 2);
  EXPECT_EQ(robot.FindLink("shank"), 2);
  EXPECT_EQ(robot.FindLink("hip"), std::nullopt);
  EXPECT_EQ(robot.FindJoint("knee"), 1);
  EXPECT_EQ(robot.FindJoint("shank"), std::nullopt);
}

TEST(RobotDescription, StopsAreReadInDegrees) {
  const Joint knee = Hopper().joints[1];
  EXPECT_DOUBLE_EQ(knee.low, -2 * std::numbers::pi / 3);
  EXPECT_DOUBLE_EQ(knee.high, std::numbers::pi / 360);
}

TEST(RobotDescription, AxesAreUnitVectors) {
  const RobotDescription robot = Hopper();
  EXPECT_THAT(robot.joints[0].axis, ElementsAre(0, 1, 0));
  EXPECT_THAT(robot.joints[1].axis, ElementsAre(0, 1, 0));  // written as [0, 2, 0]
}

TEST(RobotDescription, PosesMayLeaveJointsOut) {
  const RobotDescription robot = Hopper();
  ASSERT_EQ(robot.poses.size(), 2u);
  EXPECT_EQ(robot.poses[0].name, "upright");
  EXPECT_THAT(robot.poses[0].orientation, ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(robot.poses[0].joint_angles, ElementsAre(0, 0));
  const Pose* bent = robot.FindPose("bent");
  ASSERT_NE(bent, nullptr);
  EXPECT_THAT(bent->position, ElementsAre(0.5, 0, 1));
  EXPECT_THAT(bent->orientation, ElementsAre(0.5, 0.5, 0.5, 0.5));
  EXPECT_THAT(bent->joint_angles, ElementsAre(0.5, -1.5));
  EXPECT_EQ(robot.FindPose("lying"), nullptr);
}

TEST(RobotDescription, GroupsKeepTheOrderOfTheFileAndListMembersInAscendingOrder) {
  const RobotDescription robot = Hopper();
  ASSERT_EQ(robot.link_groups.size(), 2u);
  EXPECT_EQ(robot.link_groups[0].name, "leg");
  EXPECT_THAT(robot.link_groups[0].members, ElementsAre(1, 2));
  EXPECT_EQ(robot.link_groups[1].name, "all");
  EXPECT_THAT(robot.link_groups[1].members, ElementsAre(0, 1, 2));
  EXPECT_TRUE(robot.joint_groups.empty());
}

TEST(RobotDescription, ACoordinateDrivesItsOwnJointByOne) {
  const RobotDescription robot = Hopper();
  const DofConfiguration* dof = robot.FindDof("1");
  ASSERT_NE(dof, nullptr);
  EXPECT_EQ(dof->dof(), 1);
  EXPECT_THAT(dof->representatives, ElementsAre(0));
  ASSERT_EQ(dof->couplings.size(), 2u);
  EXPECT_EQ(dof->couplings[0].joint, 0);
  EXPECT_EQ(dof->couplings[0].factor, 1);
  EXPECT_EQ(dof->couplings[1].joint, 1);
  EXPECT_EQ(dof->couplings[1].coordinate, 0);
  EXPECT_EQ(dof->couplings[1].factor, -2);
}

TEST(RobotDescription, NetsLieInTheSpaceOfTheirConfiguration) {
  const RobotDescription robot = Hopper();
  const NetDescription* net = robot.FindNet("g3");
  ASSERT_NE(net, nullptr);
  EXPECT_EQ(net->kind, NetKind::kGrid);
  EXPECT_EQ(net->dof, "1");
  EXPECT_THAT(net->counts, ElementsAre(3));
  EXPECT_THAT(net->low, ElementsAre(-1));
  EXPECT_THAT(net->high, ElementsAre(1));
  EXPECT_EQ(robot.FindNet("g4"), nullptr);
}

RobotDescription Tinker() { return ReadRobot(ROBOTS "/tinker/robot.toml"); }

TEST(RobotDescription, OldFilesHaveHingesWithoutAnythingOfTheirOwn) {
  const RobotDescription robot = Hopper();
  EXPECT_FALSE(robot.has_fixed_base);
  EXPECT_TRUE(robot.mounts.empty());
  for (const Joint& joint : robot.joints) {
    EXPECT_EQ(joint.kind, JointKind::kHinge);
    EXPECT_EQ(joint.radius, 1);
    EXPECT_EQ(joint.passive.armature, 0);
    EXPECT_EQ(robot.GainsOf(joint).stiffness, 20);
    EXPECT_EQ(robot.GainsOf(joint).max_speed, kUnlimited);
  }
}

TEST(RobotDescription, JointsHaveTypes) {
  const RobotDescription robot = Tinker();
  ASSERT_EQ(robot.joints.size(), 3u);
  EXPECT_EQ(robot.joints[0].kind, JointKind::kHinge);
  EXPECT_EQ(robot.joints[1].kind, JointKind::kSlider);
  EXPECT_EQ(robot.joints[2].kind, JointKind::kContinuous);
  ASSERT_EQ(robot.mounts.size(), 2u);
  EXPECT_EQ(robot.mounts[0].kind, MountKind::kFixed);
  EXPECT_EQ(robot.mounts[1].kind, MountKind::kBall);
  EXPECT_THAT(robot.mounts[1].anchor, ElementsAre(-0.06, 0, 0));
  EXPECT_EQ(robot.mounts[1].damper, 0.0005);
}

TEST(RobotDescription, StopsMayBeBeyondHalfATurnOrNowhere) {
  const RobotDescription robot = Tinker();
  EXPECT_DOUBLE_EQ(robot.joints[0].high, 260 * std::numbers::pi / 180);
  EXPECT_FALSE(robot.joints[2].HasStops());
}

// 4 cm of travel are 0.8 rad of a pinion of 5 cm.
TEST(RobotDescription, ASlidersStopsAreThoseOfItsPinion) {
  const Joint rail = Tinker().joints[1];
  EXPECT_DOUBLE_EQ(rail.low, -0.6);
  EXPECT_DOUBLE_EQ(rail.high, 0.8);
}

TEST(RobotDescription, WhatAJointDoesNotSayTheControllerDoes) {
  const RobotDescription robot = Tinker();
  const Gains shoulder = robot.GainsOf(robot.joints[0]);
  EXPECT_EQ(shoulder.stiffness, 5);
  EXPECT_EQ(shoulder.max_speed, 20);
  const Gains rail = robot.GainsOf(robot.joints[1]);
  EXPECT_EQ(rail.stiffness, 20);
  EXPECT_EQ(rail.max_torque, 1);
  EXPECT_EQ(robot.joints[0].passive.spring_rest, 0.3);
}

TEST(RobotDescription, BranchesGoFromTheBaseOutwards) {
  std::vector<int> children;
  for (const Branch& branch : Tinker().Branches()) children.push_back(branch.child);
  EXPECT_THAT(children, ElementsAre(1, 3, 2, 4, 5));  // joints, then mounts
}

}  // namespace
}  // namespace robot
