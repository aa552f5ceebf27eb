#include "runtime/training/simulation/joint_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

class JointControllerTest : public testing::TestWithParam<const char*> {
 protected:
  const Profile& profile() const { return FindProfile(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(, JointControllerTest, testing::ValuesIn(BuiltProfiles()), ProfileInName);

TEST_P(JointControllerTest, TorqueIsThatOfTheSpringAndTheDamper) {
  World world(Humanoid(), profile(), Humanoid().poses[0]);
  std::vector<double> targets = Zeros(Humanoid());
  targets[8] = 0.1;
  StepFor(world, 0.01, targets);
  const double angle = dJointGetHingeAngle(world.body().joint(8).id());
  const double rate = dJointGetHingeAngleRate(world.body().joint(8).id());
  ASSERT_NE(rate, 0);
  targets[8] = 0.2;
  world.Step(targets);
  EXPECT_DOUBLE_EQ(world.controller().torques()[8], 2.5 * (0.2 - angle) - 0.08 * rate);
}

TEST_P(JointControllerTest, TorqueIsLimited) {
  World world(Humanoid(), profile(), Humanoid().poses[0]);
  std::vector<double> targets = Zeros(Humanoid());
  targets[1] = 1;  // asks for 2.5 N m
  targets[4] = -1;
  world.Step(targets);
  EXPECT_EQ(world.controller().torques()[1], 1.029);
  EXPECT_EQ(world.controller().torques()[4], -1.029);
  EXPECT_EQ(world.controller().torques()[0], 0);
}

TEST_P(JointControllerTest, APositiveTorqueIncreasesTheAngle) {
  for (size_t j = 0; j < Humanoid().joints.size(); ++j) {
    robot::Pose pose = Humanoid().poses[0];
    pose.position[2] = 10;
    World world(Humanoid(), profile(), pose);
    std::vector<double> targets = Zeros(Humanoid());
    targets[j] = 0.1;
    world.Step(targets);
    EXPECT_GT(world.controller().torques()[j], 0) << Humanoid().joints[j].name;
    EXPECT_GT(dJointGetHingeAngleRate(world.body().joint(j).id()), 0) << Humanoid().joints[j].name;
  }
}

// The limit is one of what acts, not only of what is reported: from rest, the greatest torque on
// the rotor's reduced inertia.
TEST_P(JointControllerTest, TheLimitActs) {
  robot::RobotDescription rotor = Rotor();
  rotor.controller.max_torque = 0.002;  // the spring asks for 0.01
  World world(rotor, profile(), rotor.poses[0]);
  StepFor(world, 0.1, {0});
  const double hub = 0.4 * 1.0 * 0.1 * 0.1;
  const double wheel = 0.4 * 0.5 * 0.08 * 0.08;
  const double inertia = hub * wheel / (hub + wheel);
  EXPECT_NEAR(dJointGetHingeAngleRate(world.body().joint(0).id()), -0.002 / inertia * 0.1, 1e-6);
}

// A motor's torque falls with its speed: the wheel's nears the largest speed exponentially, from
// below and, where it has been turned faster, from above.
TEST_P(JointControllerTest, ASpeedLimitIsThatOfAMotor) {
  robot::RobotDescription rotor = Rotor();
  rotor.controller = {
      .stiffness = 1, .damping = 0.001, .max_torque = 0.002, .max_speed = 2, .time_step = 0.005};
  const double hub = 0.4 * 1.0 * 0.1 * 0.1;
  const double wheel = 0.4 * 0.5 * 0.08 * 0.08;
  const double time_constant = hub * wheel / (hub + wheel) * 2 / 0.002;
  for (const double first : {0.0, -4.0}) {
    robot::StartState start = robot::RestIn(rotor.poses[0]);
    start.joint_velocities = {first};
    World world(rotor, profile(), start);
    for (int i = 1; i <= 10; ++i) {
      StepFor(world, 0.1, {-5});
      const double speed = dJointGetHingeAngleRate(world.body().joint(0).id());
      EXPECT_NEAR(speed, -2 + (first + 2) * std::exp(-0.1 * i / time_constant), 2e-3) << i;
      EXPECT_NEAR(world.controller().torques()[0], -0.002 * (1 + speed / 2), 1e-5) << i;
    }
  }
}

TEST_P(JointControllerTest, NoStepDrivesAJointBeyondItsSpeed) {
  robot::RobotDescription humanoid = Humanoid();
  humanoid.controller.max_speed = 6;
  humanoid.poses[0].position[2] = 10;
  World world(humanoid, profile(), humanoid.poses[0]);
  std::vector<double> targets = Zeros(humanoid);
  targets[1] = 2.5;
  double fastest = 0;
  for (int step = 0; step < 60; ++step) {
    world.Step(targets);
    fastest = std::max(fastest, dJointGetHingeAngleRate(world.body().joint(1).id()));
  }
  EXPECT_GT(fastest, 5.5);
  EXPECT_LT(fastest, 6.05);
}

TEST_P(JointControllerTest, FollowsTheAnalyticDampedOscillation) {
  const robot::RobotDescription rotor = Rotor();
  World world(rotor, profile(), rotor.poses[0]);
  const double hub = 0.4 * 1.0 * 0.1 * 0.1;
  const double wheel = 0.4 * 0.5 * 0.08 * 0.08;
  const double inertia = hub * wheel / (hub + wheel);
  const double decay = rotor.controller.damping / (2 * inertia);
  const double omega = std::sqrt(rotor.controller.stiffness / inertia - decay * decay);
  // Both are methods of first order: their errors shrink with the step.
  const double tolerance = 5 * world.physics_time_step();
  for (int i = 1; i <= 20; ++i) {
    StepFor(world, 0.05, {0});
    const double t = 0.05 * i;
    const double angle =
        0.5 * std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
    EXPECT_NEAR(dJointGetHingeAngle(world.body().joint(0).id()), angle, tolerance) << t;
  }
}

}  // namespace
}  // namespace runtime
