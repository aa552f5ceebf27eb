#include "runtime/analysis/robot/body_properties.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

constexpr double kHub = 0.4 * 1.0 * 0.1 * 0.1;
constexpr double kWheel = 0.4 * 0.5 * 0.08 * 0.08;

TEST(BodyProperties, KnowsMassesVolumesAndInertias) {
  const BodyProperties body = PropertiesOf(Rotor());
  EXPECT_DOUBLE_EQ(body.mass, 1.5);
  EXPECT_NEAR(body.links[0].volume, 4. / 3 * std::numbers::pi * 1e-3, 1e-12);
  EXPECT_NEAR(body.links[1].principal[2], kWheel, 1e-12);
  EXPECT_DOUBLE_EQ(body.links[0].reach, 0.1);
}

TEST(BodyProperties, AJointInTheAirFeelsBothSides) {
  robot::RobotDescription rotor = Rotor();
  rotor.joints[0].passive.armature = 1e-3;
  const JointProperties joint = PropertiesOf(rotor).joints[0];
  const double inertia = kHub * kWheel / (kHub + kWheel) + 1e-3;
  EXPECT_NEAR(joint.inertia, inertia, 1e-12);
  EXPECT_NEAR(joint.frequency, std::sqrt(0.02 / inertia) / (2 * std::numbers::pi), 1e-9);
  EXPECT_NEAR(joint.damping_ratio, 0.001 / (2 * std::sqrt(0.02 * inertia)), 1e-9);
}

TEST(BodyProperties, AJointOnAFixedBaseFeelsWhatHangsOnIt) {
  robot::RobotDescription robot = Rotor();
  robot.has_fixed_base = true;
  robot.links[1].position = {0, 0, -0.5};
  robot.joints[0].axis = {0, 1, 0};
  EXPECT_NEAR(PropertiesOf(robot).joints[0].inertia, kWheel + 0.5 * 0.25, 1e-12);
  robot.joints[0].kind = robot::JointKind::kSlider;
  robot.joints[0].radius = 0.1;
  EXPECT_NEAR(PropertiesOf(robot).joints[0].inertia, 0.5 * 0.01, 1e-12);
}

// 1.5 kg * 9.8 m/s^2 at the end of 0.5 m are 7.35 N m.
TEST(BodyProperties, AMotorIsComparedWithTheRobotsWeight) {
  robot::RobotDescription robot = Rotor();
  robot.has_fixed_base = true;
  robot.links[1].position = {0, 0, -0.5};
  robot.joints[0].axis = {0, 1, 0};
  robot.joints[0].gains.max_torque = 73.5;
  const JointProperties joint = PropertiesOf(robot).joints[0];
  EXPECT_DOUBLE_EQ(joint.reach, 0.5);
  EXPECT_NEAR(joint.strength, 10, 1e-12);
  EXPECT_NEAR(joint.quickness, 73.5 / (kWheel + 0.5 * 0.25), 1e-9);
  EXPECT_FALSE(joint.IsBeyondMotors());  // 580 rad/s^2 are not much
  robot.joints[0].gains.max_torque = 735;
  EXPECT_TRUE(PropertiesOf(robot).joints[0].IsBeyondMotors());
  robot.joints[0].kind = robot::JointKind::kSlider;
  EXPECT_EQ(PropertiesOf(robot).joints[0].strength, 0);
}

TEST(BodyProperties, APassiveJointDoesNotSwingAboutATarget) {
  robot::RobotDescription robot = Rotor();
  robot.joints[0].gains = {.stiffness = 0, .damping = 0, .max_torque = 0, .max_speed = {}};
  EXPECT_EQ(PropertiesOf(robot).joints[0].frequency, 0);
}

}  // namespace
}  // namespace runtime
