#include "runtime/training/simulation/world.h"

#include <gmock/gmock.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

// Position, orientation and velocities of every link.
std::vector<double> StateOf(const World& world) {
  std::vector<double> state;
  for (int i = 0; i < world.body().link_count(); ++i) {
    const dBodyID body = world.body().body(i);
    const dReal* parts[] = {dBodyGetPosition(body), dBodyGetLinearVel(body),
                            dBodyGetAngularVel(body)};
    for (const dReal* part : parts) state.insert(state.end(), part, part + 3);
    const dReal* orientation = dBodyGetQuaternion(body);
    state.insert(state.end(), orientation, orientation + 4);
  }
  return state;
}

class WorldTest : public testing::TestWithParam<const char*> {
 protected:
  World Make(const robot::RobotDescription& robot, const robot::Pose& pose) const {
    return World(robot, FindProfile(GetParam()), pose);
  }
};

INSTANTIATE_TEST_SUITE_P(, WorldTest, testing::ValuesIn(BuiltProfiles()), ProfileInName);

TEST_P(WorldTest, TheRobotWeighsWhatItsDescriptionSays) {
  const World world = Make(Humanoid(), Humanoid().poses[0]);
  double total = 0;
  for (int i = 0; i < world.body().link_count(); ++i) {
    dMass mass;
    dBodyGetMass(world.body().body(i), &mass);
    EXPECT_NEAR(mass.mass, Humanoid().links[i].mass, 1e-15);
    total += mass.mass;
  }
  EXPECT_NEAR(total, 1.2, 1e-9);
}

TEST_P(WorldTest, HingesHoldTogetherInEveryPose) {
  for (const robot::Pose& pose : Humanoid().poses) {
    const World world = Make(Humanoid(), pose);
    for (int j = 0; j < world.body().joint_count(); ++j) {
      dVector3 of_parent, of_child;
      dJointGetHingeAnchor(world.body().joint(j).id(), of_parent);
      dJointGetHingeAnchor2(world.body().joint(j).id(), of_child);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(of_parent[k], of_child[k], 1e-9) << pose.name << " " << j;
      }
    }
  }
}

TEST_P(WorldTest, StandsStillOnEightContacts) {
  World world = Make(Humanoid(), Humanoid().poses[0]);
  StepFor(world, 1.2, Zeros(Humanoid()));
  const dReal* position = dBodyGetPosition(world.body().body(0));
  EXPECT_NEAR(position[2], 0.2421, 1e-4);
  EXPECT_NEAR(position[0], 0, 5e-3);
  EXPECT_NEAR(position[1], 0, 1e-3);
  EXPECT_EQ(world.collision().contacts().size(), 8);
  EXPECT_TRUE(world.contacts().flag(12) && world.contacts().flag(17));
  EXPECT_FALSE(world.contacts().flag(0));
}

TEST_P(WorldTest, LyingTouchesTheGroundWithHeadHandsAndThighs) {
  World world = Make(Humanoid(), Humanoid().poses[1]);
  EXPECT_THAT(GroundLinks(world, Humanoid()),
              ElementsAre("head", "left_hand", "right_hand", "left_thigh", "right_thigh"));
  StepFor(world, 1, Zeros(Humanoid()));
  EXPECT_FALSE(world.contacts().flag(0));
}

TEST_P(WorldTest, FallsAsTheStepOfTheMethodSays) {
  robot::Pose pose = Humanoid().poses[0];
  pose.position[2] = 10;
  World world = Make(Humanoid(), pose);
  const int steps = static_cast<int>(0.5 / world.physics_time_step() + 0.5);
  for (int i = 0; i < steps; ++i) world.Step(Zeros(Humanoid()));
  const double h = world.physics_time_step();
  // Velocities first: after n steps the fall is g h^2 n (n + 1) / 2, a little more than g t^2 / 2.
  const double fall = 9.8 * h * h * steps * (steps + 1) / 2;
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 10 - fall, 1e-9);
  EXPECT_NEAR(dBodyGetLinearVel(world.body().body(0))[2], -9.8 * 0.5, 1e-9);
  EXPECT_NEAR(fall, 9.8 * 0.5 * 0.5 / 2, 9.8 * 0.5 * h);
}

TEST_P(WorldTest, MomentumIsKeptInTheAir) {
  robot::Pose pose = Humanoid().poses[0];
  pose.position[2] = 10;
  World world = Make(Humanoid(), pose);
  std::vector<double> targets = Zeros(Humanoid());
  targets[1] = 1;
  targets[13] = -0.5;
  StepFor(world, 0.3, targets);
  double x = 0, y = 0;
  for (size_t i = 0; i < Humanoid().links.size(); ++i) {
    const dReal* velocity = dBodyGetLinearVel(world.body().body(i));
    x += Humanoid().links[i].mass * velocity[0];
    y += Humanoid().links[i].mass * velocity[1];
  }
  // That of MuJoCo's, whose joints do not give, is kept but for the bend of their ways in a step.
  const double tolerance = IsMujoco(GetParam()) ? 0.005 : 1e-9;
  EXPECT_NEAR(x, 0, tolerance);
  EXPECT_NEAR(y, 0, tolerance);
}

TEST_P(WorldTest, AnglesHaveTheSignsOfThePaper) {
  robot::Pose pose = Humanoid().poses[0];
  pose.position[2] = 10;
  World world = Make(Humanoid(), pose);
  std::vector<double> targets = Zeros(Humanoid());
  targets[Humanoid().FindJoint("left_hip_pitch").value()] = 0.5;
  targets[Humanoid().FindJoint("right_knee_pitch").value()] = -0.8;
  targets[Humanoid().FindJoint("left_shoulder_roll").value()] = -0.5;
  targets[Humanoid().FindJoint("right_shoulder_pitch").value()] = 0.8;
  StepFor(world, 0.3, targets);
  const auto from_base = [&](const char* link) {
    const dReal* position = dBodyGetPosition(Link(world, Humanoid(), link));
    dVector3 relative;
    dBodyGetPosRelPoint(world.body().body(0), position[0], position[1], position[2], relative);
    return std::array<double, 3>{relative[0], relative[1], relative[2]};
  };
  EXPECT_GT(from_base("left_shank")[0], 0.02);   // forward
  EXPECT_LT(from_base("right_foot")[0], -0.02);  // a knee bends to the back
  EXPECT_GT(from_base("left_hand")[1], 0.1);     // away from the body
  EXPECT_GT(from_base("right_hand")[0], 0.02);   // forward
}

TEST_P(WorldTest, StopsHold) {
  robot::Pose pose = Humanoid().poses[0];
  pose.position[2] = 10;
  World world = Make(Humanoid(), pose);
  std::vector<double> targets = Zeros(Humanoid());
  targets[9] = 1;  // the knee's stop is at 10 degrees
  StepFor(world, 1, targets);
  EXPECT_NEAR(dJointGetHingeAngle(world.body().joint(9).id()), M_PI / 18, 0.01);
}

TEST_P(WorldTest, EqualWorldsStayEqualBitForBit) {
  const auto run = [this] {
    World world = Make(Humanoid(), Humanoid().poses[0]);
    std::vector<double> targets = Zeros(Humanoid());
    for (int i = 0; i < 6; ++i) {
      for (size_t j = 0; j < targets.size(); ++j) targets[j] = std::sin(3.0 * i + j);
      StepFor(world, 0.05, targets);
    }
    return StateOf(world);
  };
  const std::vector<double> first = run();
  const std::vector<double> second = run();
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)), 0);
}

TEST_P(WorldTest, AnotherRobotWorksFromItsDescriptionOnly) {
  robot::Pose pose = Hopper().poses[0];
  pose.position[2] += 0.002;  // lets it drop
  World world = Make(Hopper(), pose);
  EXPECT_FALSE(world.contacts().flag(2));
  StepFor(world, 0.2, {0, 0});
  EXPECT_THAT(GroundLinks(world, Hopper()), ElementsAre("shank"));
  EXPECT_TRUE(world.contacts().flag(2));
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 0.23, 0.01);
}

TEST_P(WorldTest, ARobotWithoutJointsIsABody) {
  robot::RobotDescription ball = Rotor();
  ball.links.resize(1);
  ball.joints.clear();
  ball.poses = {{"", {0, 0, 0.2}, {1, 0, 0, 0}, {}}};
  World world = Make(ball, ball.poses[0]);
  StepFor(world, 1, {});
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 0.1, 1e-3);
}

// ODE measures angles from -pi to pi, and would throw such a joint all the way around.
TEST_P(WorldTest, AJointThatGivesWayBeyondHalfATurnComesBack) {
  robot::RobotDescription rotor = Rotor();
  rotor.joints[0].low = -0.5;
  rotor.joints[0].high = 3.14;
  rotor.poses[0].joint_angles[0] = 3;
  World world = Make(rotor, rotor.poses[0]);
  dBodySetAngularVel(world.body().body(1), 0, 0, -30);
  double largest = 0;
  for (double time = 0; time < 0.2; time += world.physics_time_step()) {
    world.Step(std::vector{3.0});
    const double angle = world.body().JointAngle(0);
    ASSERT_GT(angle, 2) << time;
    largest = std::max(largest, angle);
  }
  EXPECT_GT(largest, M_PI);
  EXPECT_LT(largest, 3.5);
}

TEST_P(WorldTest, AnAbsurdStateIsAFailure) {
  World world = Make(Humanoid(), Humanoid().poses[0]);
  dBodySetLinearVel(world.body().body(0), 1e6, 0, 0);
  EXPECT_THROW(world.Step(Zeros(Humanoid())), OdeFailure);
}

TEST_P(WorldTest, AStateThatIsNoNumberIsAFailure) {
  World world = Make(Humanoid(), Humanoid().poses[0]);
  dBodySetAngularVel(world.body().body(3), 0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_THROW(world.Step(Zeros(Humanoid())), OdeFailure);
}

TEST_P(WorldTest, ATargetThatIsNoNumberIsAFailure) {
  World world = Make(Humanoid(), Humanoid().poses[0]);
  std::vector<double> targets = Zeros(Humanoid());
  targets[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(StepFor(world, 0.01, targets), OdeFailure);
}

// Nothing of ours looks at the speed of a link without joints before ODE does.
TEST(World, AFailureInTheMiddleOfAStepLeavesOtherWorldsAlone) {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler ode_loses_its_open_jobs;
#endif
  robot::RobotDescription ball = Rotor();
  ball.links.resize(1);
  ball.joints.clear();
  ball.poses = {{"", {0, 0, 1}, {1, 0, 0, 0}, {}}};
  {
    World world(ball, FindProfile("paper"), ball.poses[0]);
    dBodySetAngularVel(world.body().body(0), std::numeric_limits<double>::quiet_NaN(), 0, 0);
    EXPECT_THROW(world.Step({}), OdeFailure);
  }
  World world(ball, FindProfile("paper"), ball.poses[0]);
  world.Step({});
  EXPECT_NEAR(dBodyGetLinearVel(world.body().body(0))[2], -9.8 * 0.0002, 1e-15);
}

TEST(World, AnUnstableControllerIsAFailure) {
  robot::RobotDescription robot = Humanoid();
  robot.controller.stiffness = 1e5;
  robot.controller.damping = 1e3;
  robot.controller.max_torque = 1e9;
  World world(robot, FindProfile("paper"), robot.poses[0]);
  EXPECT_THROW(StepFor(world, 1, std::vector<double>(17, 0.1)), OdeFailure);
}

// Both pairs of profiles, 0.5 s long.
void ExpectPaperAndFastAgreeInTheAir(const robot::RobotDescription& robot,
                                     const std::vector<double>& targets) {
  robot::Pose pose = robot.poses[0];
  pose.position[2] = 100;
  for (const std::string solver : {"", "-tree"}) {
    World paper(robot, FindProfile("paper" + solver), pose);
    World fast(robot, FindProfile("fast" + solver), pose);
    for (int i = 0; i < 10; ++i) {
      StepFor(paper, 0.05, targets);
      StepFor(fast, 0.05, targets);
      for (int j = 0; j < paper.body().joint_count(); ++j) {
        EXPECT_NEAR(fast.body().JointAngle(j), paper.body().JointAngle(j), 0.03)
            << i << " " << robot.joints[j].name << solver;
      }
    }
  }
}

TEST(World, PaperAndFastAgreeInTheAir) {
  std::vector<double> targets = Zeros(Humanoid());
  for (const int j : {1, 4, 8, 13}) targets[j] = 0.4;
  for (const int j : {9, 14}) targets[j] = -0.4;
  ExpectPaperAndFastAgreeInTheAir(Humanoid(), targets);
}

// The feet's motors are turned by the swing of the legs.
TEST(World, PaperAndFastAgreeOnMotorsThatAreTurnedTooFast) {
  const robot::RobotDescription hexapod = robot::ReadRobot(HEXAPOD);
  std::vector<double> targets(hexapod.joints.size());
  for (size_t j = 0; j < targets.size(); ++j) targets[j] = j % 2 == 0 ? 1 : -1;
  ExpectPaperAndFastAgreeInTheAir(hexapod, targets);
}

}  // namespace
}  // namespace runtime
