#include "runtime/training/learning/joint_mirror.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::HasSubstr;

int JointNamed(const char* name) { return Humanoid().FindJoint(name).value(); }

void ExpectMirror(const char* joint, const char* image, double sign) {
  const MirroredJoint mirrored = MirrorJoints(Humanoid())[static_cast<size_t>(JointNamed(joint))];
  EXPECT_EQ(mirrored.joint, JointNamed(image)) << joint;
  EXPECT_EQ(mirrored.sign, sign) << joint;
}

// What swings a leg forward does so on both sides; what turns it outward turns the other way.
TEST(JointMirror, FindsTheOtherSideOfTheHumanoid) {
  ExpectMirror("left_hip_pitch", "right_hip_pitch", 1);
  ExpectMirror("right_elbow_pitch", "left_elbow_pitch", 1);
  ExpectMirror("left_hip_roll", "right_hip_roll", -1);
  ExpectMirror("right_shoulder_roll", "left_shoulder_roll", -1);
  ExpectMirror("neck_yaw", "neck_yaw", -1);
}

TEST(JointMirror, OneSideHasTheFirstOfEachPair) {
  std::vector<std::string> names;
  for (const int joint : OneSide(Humanoid())) {
    names.push_back(Humanoid().joints[static_cast<size_t>(joint)].name);
  }
  EXPECT_THAT(names,
              testing::ElementsAre("left_shoulder_pitch", "left_shoulder_roll", "left_elbow_pitch",
                                   "left_hip_roll", "left_hip_pitch", "left_knee_pitch",
                                   "left_ankle_pitch", "left_ankle_roll"));
}

TEST(JointMirror, ADofConfigurationIsDoneByTheOtherSide) {
  robot::DofConfiguration left;
  left.name = "left";
  left.representatives = {JointNamed("left_hip_roll")};
  left.couplings = {{.joint = JointNamed("left_hip_roll"), .coordinate = 0, .factor = 1},
                    {.joint = JointNamed("left_knee_pitch"), .coordinate = 0, .factor = 0.5}};
  const robot::DofConfiguration right = MirrorDof(Humanoid(), left, "player.dof");
  ASSERT_EQ(right.couplings.size(), 2u);
  EXPECT_EQ(right.couplings[0].joint, JointNamed("right_hip_roll"));
  EXPECT_EQ(right.couplings[0].factor, -1);
  EXPECT_EQ(right.couplings[1].joint, JointNamed("right_knee_pitch"));
  EXPECT_EQ(right.couplings[1].factor, 0.5);
}

TEST(JointMirror, WhatHasNoOtherSideIsRefused) {
  EXPECT_THAT(
      UserErrorOf([] { MirrorDof(Humanoid(), *Humanoid().FindDof("5"), "player.dof"); }),
      HasSubstr("`player.dof`: the DoF configuration `5` moves `left_shoulder_pitch` and its "
                "mirror image `right_shoulder_pitch`; choose one that moves one side, or "
                "\"all\""));

  robot::RobotDescription lopsided = Humanoid();
  lopsided.joints[static_cast<size_t>(JointNamed("right_hip_pitch"))].anchor[2] += 0.01;
  robot::DofConfiguration hip;
  hip.name = "hip";
  hip.representatives = {JointNamed("left_hip_pitch")};
  hip.couplings = {{.joint = JointNamed("left_hip_pitch"), .coordinate = 0}};
  EXPECT_THAT(UserErrorOf([&] { MirrorDof(lopsided, hip, "player.dof"); }),
              HasSubstr("the robot `humanoid` has no joint that mirrors `left_hip_pitch`"));
}

}  // namespace
}  // namespace runtime
