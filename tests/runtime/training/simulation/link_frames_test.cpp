#include "runtime/training/simulation/link_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

constexpr double kPi = std::numbers::pi;

robot::Pose Pose(const robot::RobotDescription& robot) {
  return {"", {0, 0, 0}, {1, 0, 0, 0}, Zeros(robot)};
}

void ExpectAt(const LinkFrame& frame, double x, double y, double z) {
  EXPECT_NEAR((frame.position - Eigen::Vector3d(x, y, z)).norm(), 0, 1e-12)
      << frame.position.transpose();
}

TEST(LinkFrames, ZeroPoseIsThatOfTheDescription) {
  const std::vector<LinkFrame> frames = LinkFrames(Humanoid(), Pose(Humanoid()));
  ASSERT_EQ(frames.size(), 18u);
  for (size_t i = 0; i < frames.size(); ++i) {
    const robot::Vector3& p = Humanoid().links[i].position;
    EXPECT_EQ(frames[i].position, Eigen::Vector3d(p[0], p[1], p[2])) << i;
    EXPECT_EQ(frames[i].orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs()) << i;
  }
}

TEST(LinkFrames, APositiveHipAngleSwingsTheLegForward) {
  robot::Pose pose = Pose(Hopper());
  pose.joint_angles = {kPi / 2, 0};
  const std::vector<LinkFrame> frames = LinkFrames(Hopper(), pose);
  // The hip is at z = -0.05; the thigh was 0.05 below it, the shank 0.15.
  ExpectAt(frames[0], 0, 0, 0);
  ExpectAt(frames[1], 0.05, 0, -0.05);
  ExpectAt(frames[2], 0.15, 0, -0.05);
}

TEST(LinkFrames, JointsFurtherOutTurnAboutTheirMovedAxes) {
  robot::Pose pose = Pose(Hopper());
  pose.joint_angles = {kPi / 2, -kPi / 2};
  const std::vector<LinkFrame> frames = LinkFrames(Hopper(), pose);
  // The thigh points forward, the knee is 0.1 in front of the hip, the shank hangs from it again.
  ExpectAt(frames[1], 0.05, 0, -0.05);
  ExpectAt(frames[2], 0.1, 0, -0.1);
  EXPECT_NEAR(frames[2].orientation.angularDistance(Eigen::Quaterniond::Identity()), 0, 1e-7);
}

TEST(LinkFrames, TheRobotIsTurnedAboutItsBaseAndThenMoved) {
  robot::Pose pose = Pose(Hopper());
  pose.position = {1, 2, 3};
  pose.orientation = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};  // 90 degrees about y: z turns to x
  const std::vector<LinkFrame> frames = LinkFrames(Hopper(), pose);
  ExpectAt(frames[0], 1, 2, 3);
  ExpectAt(frames[1], 0.9, 2, 3);
  ExpectAt(frames[2], 0.8, 2, 3);
}

TEST(LinkFrames, APoseTurnsTheLinksAsItsJointsAfterwardsMeasure) {
  for (const robot::Pose& pose : Humanoid().poses) {
    const World world(Humanoid(), FindProfile("paper"), pose);
    for (size_t j = 0; j < pose.joint_angles.size(); ++j) {
      EXPECT_NEAR(dJointGetHingeAngle(world.body().joint(j).id()), pose.joint_angles[j], 1e-9)
          << pose.name << " " << Humanoid().joints[j].name;
    }
  }
}

}  // namespace
}  // namespace runtime
