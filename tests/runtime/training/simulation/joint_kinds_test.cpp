// What each kind of joint does, against what is known of it.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

constexpr double kGravity = robot::kGravity;

class JointKindsTest : public testing::TestWithParam<const char*> {
 protected:
  World Make(const robot::RobotDescription& robot) const {
    return World(robot, FindProfile(GetParam()), robot.poses[0]);
  }
};

INSTANTIATE_TEST_SUITE_P(, JointKindsTest, testing::ValuesIn(BuiltProfiles()), ProfileInName);

// The rotor's inertia about its axle, of which both balls take their part.
constexpr double kHub = 0.4 * 1.0 * 0.1 * 0.1;
constexpr double kWheel = 0.4 * 0.5 * 0.08 * 0.08;
constexpr double kReduced = kHub * kWheel / (kHub + kWheel);

void RemoveMotor(robot::Joint& joint) {
  joint.gains = {.stiffness = 0, .damping = 0, .max_torque = 0, .max_speed = {}};
}

// A ball that hangs 0.5 m below a base in the air that does not move.
robot::RobotDescription Hanging() {
  robot::RobotDescription robot = Rotor();
  robot.has_fixed_base = true;
  robot.links[1].position = {0, 0, -0.5};
  robot.joints[0].axis = {0, 1, 0};
  robot.poses[0].joint_angles[0] = 0;
  RemoveMotor(robot.joints[0]);
  return robot;
}

void ExpectOscillation(World& world, double amplitude, double inertia, double stiffness,
                       double damping) {
  const double decay = damping / (2 * inertia);
  const double omega = std::sqrt(stiffness / inertia - decay * decay);
  const double tolerance = 10 * amplitude * world.physics_time_step();  // methods of first order
  for (int i = 1; i <= 20; ++i) {
    StepFor(world, 0.05, {0});
    const double t = 0.05 * i;
    const double angle = amplitude * std::exp(-decay * t) *
                         (std::cos(omega * t) + decay / omega * std::sin(omega * t));
    EXPECT_NEAR(world.body().JointAngle(0), angle, tolerance) << t;
  }
}

TEST_P(JointKindsTest, AnArmatureAddsToTheInertia) {
  robot::RobotDescription rotor = Rotor();
  rotor.joints[0].passive.armature = 2 * kReduced;
  World world = Make(rotor);
  ExpectOscillation(world, 0.5, 3 * kReduced, 0.02, 0.001);
}

TEST_P(JointKindsTest, APassiveJointFollowsItsSpringAndDamper) {
  robot::RobotDescription rotor = Rotor();
  RemoveMotor(rotor.joints[0]);
  rotor.joints[0].passive = {.spring = 0.02, .damper = 0.001};
  World world = Make(rotor);
  ExpectOscillation(world, 0.5, kReduced, 0.02, 0.001);
  EXPECT_EQ(world.controller().torques()[0], 0);
}

TEST_P(JointKindsTest, ASpringPullsTowardItsRest) {
  robot::RobotDescription rotor = Rotor();
  rotor.has_fixed_base = true;
  RemoveMotor(rotor.joints[0]);
  rotor.joints[0].passive = {.spring = 0.02, .spring_rest = -0.3, .damper = 0.01};
  World world = Make(rotor);
  StepFor(world, 4, {0});
  EXPECT_NEAR(world.body().JointAngle(0), -0.3, 1e-3);
}

TEST_P(JointKindsTest, FrictionStopsAJointAndHoldsIt) {
  robot::RobotDescription rotor = Rotor();
  RemoveMotor(rotor.joints[0]);
  rotor.poses[0].joint_angles[0] = 0;
  rotor.joints[0].passive = {.friction = 0.002};
  robot::StartState start = robot::RestIn(rotor.poses[0]);
  start.joint_velocities[0] = 2;
  World world(rotor, FindProfile(GetParam()), start);
  const double slowing = 0.002 / kReduced;  // [rad / s^2]
  StepFor(world, 0.2, {0});
  EXPECT_NEAR(world.body().joint(0).Rate(), 2 - 0.2 * slowing, 1e-4);
  StepFor(world, 2 / slowing, {0});
  EXPECT_NEAR(world.body().joint(0).Rate(), 0, 1e-9);
  EXPECT_NEAR(world.body().JointAngle(0), 2 * 2 / (2 * slowing), 0.01);
}

TEST_P(JointKindsTest, AJointHasItsOwnGains) {
  robot::RobotDescription rotor = Rotor();
  rotor.joints[0].gains = {.stiffness = 1, .damping = 0.01, .max_torque = 0.3, .max_speed = {}};
  World world = Make(rotor);
  world.Step(std::vector{0.4});
  EXPECT_DOUBLE_EQ(world.controller().torques()[0], 0.4 - 0.5);
  world.Step(std::vector{-3.0});
  EXPECT_EQ(world.controller().torques()[0], -0.3);
}

TEST_P(JointKindsTest, APendulumOnAFixedBaseSwings) {
  for (const double armature : {0.0, 0.1}) {
    robot::RobotDescription robot = Hanging();
    robot.poses[0].joint_angles[0] = 0.05;
    robot.joints[0].passive.armature = armature;
    World world = Make(robot);
    const double inertia = 0.5 * 0.5 * 0.5 + kWheel + armature;
    ExpectOscillation(world, 0.05, inertia, 0.5 * kGravity * 0.5, 0);
    EXPECT_EQ(dBodyGetPosition(world.body().body(0))[2], 100);
  }
}

TEST_P(JointKindsTest, ASliderOnASpringOscillates) {
  robot::RobotDescription robot = Hanging();
  robot.joints[0].kind = robot::JointKind::kSlider;
  robot.joints[0].axis = {0, 0, 1};
  robot.joints[0].radius = 0.2;
  // 8 N/m felt at the pinion, around the place where it carries the ball.
  const double stiffness = 8 * 0.2 * 0.2;
  const double sag = -0.5 * kGravity / 8 / 0.2;
  robot.joints[0].passive = {.spring = stiffness, .spring_rest = -sag};
  robot.poses[0].joint_angles[0] = 0.1;
  World world = Make(robot);
  EXPECT_NEAR(dBodyGetPosition(world.body().body(1))[2], 100 - 0.5 + 0.02, 1e-12);
  ExpectOscillation(world, 0.1, 0.5 * 0.2 * 0.2, stiffness, 0);
}

TEST_P(JointKindsTest, ASliderIsDrivenToItsTargetAndHeldByItsStops) {
  robot::RobotDescription robot = Hanging();
  robot.joints[0] = Rotor().joints[0];
  robot.joints[0].kind = robot::JointKind::kSlider;
  robot.joints[0].axis = {1, 0, 0};
  robot.joints[0].radius = 0.1;
  robot.joints[0].low = -2;
  robot.joints[0].high = 2;
  robot.controller = {.stiffness = 1, .damping = 0.2, .max_torque = 10, .time_step = 0.005};
  World world = Make(robot);
  StepFor(world, 2, {1});
  EXPECT_NEAR(world.body().JointAngle(0), 1, 1e-3);
  EXPECT_NEAR(dBodyGetPosition(world.body().body(1))[0], 0.1, 1e-4);
  StepFor(world, 2, {5});
  EXPECT_NEAR(world.body().JointAngle(0), 2, 0.01);
}

// Nothing outside acts along the rail: the two move against each other.
TEST_P(JointKindsTest, ASliderKeepsMomentum) {
  robot::RobotDescription robot = Rotor();
  robot.links[1].position = {0, 0.3, 0};
  robot.joints[0].kind = robot::JointKind::kSlider;
  robot.joints[0].axis = {1, 0, 0};
  World world = Make(robot);
  StepFor(world, 0.3, {-0.5});
  const dReal* hub = dBodyGetLinearVel(world.body().body(0));
  const dReal* wheel = dBodyGetLinearVel(world.body().body(1));
  EXPECT_LT(wheel[0], -1e-4);
  EXPECT_NEAR(1.0 * hub[0] + 0.5 * wheel[0], 0, IsMujoco(GetParam()) ? 1e-5 : 1e-9);
  const auto place = [&](int link) { return ToEigen(dBodyGetPosition(world.body().body(link))); };
  const Vector3 between = ToEigen(wheel) - ToEigen(hub);
  const Vector3 moved = 1.0 * 0.5 / 1.5 * (place(1) - place(0)).cross(between);
  const double turned = kHub * dBodyGetAngularVel(world.body().body(0))[2] +
                        kWheel * dBodyGetAngularVel(world.body().body(1))[2];
  EXPECT_GT(std::abs(turned), 1e-5);
  EXPECT_NEAR(turned + moved.z(), 0, 1e-6);
}

// Also where its axis turns with the parent, which is no part of the links' own velocities.
TEST_P(JointKindsTest, ASlidersRateIsThatOfItsAngle) {
  robot::RobotDescription robot = Rotor();
  robot.links[1].position = {0, 0.3, 0};
  robot.joints[0].kind = robot::JointKind::kSlider;
  robot.joints[0].axis = {1, 0, 0};
  RemoveMotor(robot.joints[0]);
  robot::StartState start = robot::RestIn(robot.poses[0]);
  start.angular_velocity = {0, 0, 3};
  start.joint_velocities[0] = 0.5;
  World world(robot, FindProfile(GetParam()), start);
  EXPECT_NEAR(world.body().joint(0).Rate(), 0.5, 1e-9);
  for (int i = 0; i < 10; ++i) {
    const double before = world.body().JointAngle(0);
    StepFor(world, 0.02, {0});
    const double mean = (world.body().JointAngle(0) - before) / 0.02;
    EXPECT_NEAR(world.body().joint(0).Rate(), mean, 0.1) << i;
  }
}

TEST_P(JointKindsTest, AContinuousJointCountsItsTurns) {
  robot::RobotDescription rotor = Rotor();
  rotor.joints[0].kind = robot::JointKind::kContinuous;
  rotor.joints[0].low = -robot::kUnlimited;
  rotor.joints[0].high = robot::kUnlimited;
  rotor.poses[0].joint_angles[0] = 7;
  rotor.has_fixed_base = true;
  rotor.controller.stiffness = 0.2;
  rotor.controller.damping = 0.04;
  World world = Make(rotor);
  EXPECT_NEAR(world.body().JointAngle(0), 7, 1e-12);
  StepFor(world, 3, {30});
  EXPECT_NEAR(world.body().JointAngle(0), 30, 0.02);
  StepFor(world, 3, {-30});
  EXPECT_NEAR(world.body().JointAngle(0), -30, 0.02);
}

TEST_P(JointKindsTest, StopsMayBeBeyondHalfATurn) {
  robot::RobotDescription rotor = Rotor();
  rotor.joints[0].low = 2;
  rotor.joints[0].high = 5;
  rotor.poses[0].joint_angles[0] = 4;
  rotor.has_fixed_base = true;
  rotor.controller.stiffness = 0.2;
  rotor.controller.damping = 0.04;
  World world = Make(rotor);
  EXPECT_NEAR(world.body().JointAngle(0), 4, 1e-12);
  StepFor(world, 1.5, {7});
  EXPECT_NEAR(world.body().JointAngle(0), 5, 0.01);
  StepFor(world, 1.5, {-3});
  EXPECT_NEAR(world.body().JointAngle(0), 2, 0.01);
}

robot::RobotDescription Mounted(robot::MountKind kind) {
  robot::RobotDescription robot = Hanging();
  robot.mounts = {{"mount", kind, 0, 1, {0, 0, 0}, 0}};
  robot.joints.clear();
  robot.poses[0].joint_angles.clear();
  return robot;
}

TEST_P(JointKindsTest, AFixedMountHolds) {
  World world = Make(Mounted(robot::MountKind::kFixed));
  StepFor(world, 1, {});
  const dReal* position = dBodyGetPosition(world.body().body(1));
  EXPECT_NEAR(position[0], 0, 1e-9);
  EXPECT_NEAR(position[2], 99.5, 1e-4);
}

// A ball that circles at 45 degrees stays at its height.
TEST_P(JointKindsTest, ABallJointLetsAPendulumCircle) {
  robot::RobotDescription robot = Mounted(robot::MountKind::kBall);
  robot.links[1].position = {0.5 * std::sqrt(0.5), 0, -0.5 * std::sqrt(0.5)};
  robot.links[1].shape.radius = 0.001;  // a point
  World world = Make(robot);
  const double radius = 0.5 * std::sqrt(0.5);
  const double speed = std::sqrt(kGravity * radius);
  dBodySetLinearVel(world.body().body(1), 0, speed, 0);
  dBodySetAngularVel(world.body().body(1), 0, 0, speed / radius);
  const double period = 2 * M_PI * radius / speed;
  StepFor(world, period / 4, {});
  const dReal* position = dBodyGetPosition(world.body().body(1));
  EXPECT_NEAR(position[1], radius, 0.01);
  EXPECT_NEAR(position[2], 100 - radius, 0.01);
}

TEST_P(JointKindsTest, ABallsDamperStopsItsTurning) {
  robot::RobotDescription robot = Mounted(robot::MountKind::kBall);
  robot.links[1].position = {0, 0, 0};
  robot.mounts[0].damper = 0.01;
  World world = Make(robot);
  dBodySetAngularVel(world.body().body(1), 1, 2, -1);
  StepFor(world, kWheel / 0.01, {});  // one time constant
  const dReal* turning = dBodyGetAngularVel(world.body().body(1));
  EXPECT_NEAR(turning[1], 2 * std::exp(-1), 0.02);
  EXPECT_NEAR(turning[2], -1 * std::exp(-1), 0.02);
}

TEST_P(JointKindsTest, AFreeRobotWithMountsFallsFreely) {
  robot::RobotDescription robot = Tinker();
  robot.poses[1].position[2] = 10;
  World world(robot, FindProfile(GetParam()), robot.poses[1]);
  const double start = CenterOfMass(world, robot).z();
  StepFor(world, 0.5, {0, 0, 0});
  EXPECT_NEAR(CenterOfMass(world, robot).z(), start - kGravity * 0.5 * 0.5 / 2, 0.01);
}

}  // namespace
}  // namespace runtime
