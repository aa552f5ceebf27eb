// Things and ground that is not flat, against what is known of them in closed form.
#include "runtime/training/simulation/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include "plugins/world/ground.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using world::Thing;
using world::WorldDescription;

const robot::LinkShape kBall{.kind = robot::ShapeKind::kSphere, .radius = 0.1};
const robot::LinkShape kBox{.kind = robot::ShapeKind::kBox, .size = {0.2, 0.2, 0.1}};

Thing MakeThing(const char* name, const robot::LinkShape& shape, double mass,
                const robot::Vector3& position) {
  return {.name = name, .shape = shape, .mass = mass, .position = position};
}

// A single ball of 1 kg that nothing drives, far from all that is tested.
robot::RobotDescription Marble(const robot::Vector3& position = {-50, 0, 0.1}) {
  robot::RobotDescription robot;
  robot.name = "marble";
  robot.links = {{"marble", 1.0, {0, 0, 0}, kBall}};
  robot.controller = {.stiffness = 1, .damping = 1, .max_torque = 1, .time_step = 0.005};
  robot.poses = {{"there", position, {1, 0, 0, 0}, {}}};
  return robot;
}

class SurroundingsTest : public testing::TestWithParam<const char*> {
 protected:
  World Make(const robot::RobotDescription& robot, const WorldDescription& around) {
    return World(robot, FindProfile(GetParam()), robot.poses[0], &around);
  }
  static dBodyID BodyOf(const World& world, size_t thing) {
    return world.body().body(world.surroundings().BodyOf(thing));
  }
  static Eigen::Vector3d Place(const World& world, size_t thing) {
    return ToEigen(dBodyGetPosition(BodyOf(world, thing)));
  }
  static Eigen::Vector3d Speed(const World& world, size_t thing) {
    return ToEigen(dBodyGetLinearVel(BodyOf(world, thing)));
  }
};

INSTANTIATE_TEST_SUITE_P(, SurroundingsTest, testing::ValuesIn(BuiltProfiles()), ProfileInName);

TEST_P(SurroundingsTest, AThingFallsAsGravitySays) {
  const robot::RobotDescription robot = Marble();
  const WorldDescription around{.things = {MakeThing("ball", kBall, 0.3, {0, 0, 5})}};
  World world = Make(robot, around);
  const double h = world.physics_time_step();
  const int steps = static_cast<int>(0.5 / h + 0.5);
  for (int i = 0; i < steps; ++i) world.Step({});
  // Velocities first, then places: the sum of an arithmetic series.
  EXPECT_NEAR(Place(world, 0).z(), 5 - robot::kGravity * h * h * steps * (steps + 1) / 2, 1e-9);
  EXPECT_NEAR(Speed(world, 0).z(), -robot::kGravity * h * steps, 1e-9);
}

// What rolls without sliding has 2/5 of its mass as inertia to turn.
TEST_P(SurroundingsTest, ABallRollsDownASlope) {
  const robot::RobotDescription robot = Marble();
  const double angle = 0.1;
  WorldDescription around{.ground = {world::Slope{.angle = angle}}};
  around.things = {MakeThing("ball", kBall, 0.3, {})};
  world::PutDown(around.ground, 0, 0, {1, 0, 0, 0}, around.things[0]);
  World world = Make(robot, around);
  const Eigen::Vector3d start = Place(world, 0);
  constexpr double kSeconds = 1;
  StepFor(world, kSeconds, {});
  const double acceleration = robot::kGravity * std::sin(angle) * 5 / 7;
  const double way = acceleration * kSeconds * kSeconds / 2;
  EXPECT_NEAR((Place(world, 0) - start).norm(), way, 0.01 * way);
  EXPECT_LT(Place(world, 0).x(), start.x());  // it rises toward +x
  const double turning = ToEigen(dBodyGetAngularVel(BodyOf(world, 0))).norm();
  EXPECT_NEAR(turning, Speed(world, 0).norm() / kBall.radius, 0.01 * turning);
}

TEST_P(SurroundingsTest, ABoxSlidesWhereTheSlopeIsSteeperThanItsFriction) {
  const robot::RobotDescription robot = Marble();
  constexpr double kFriction = 0.3;
  for (const double angle : {0.8 * std::atan(kFriction), 1.3 * std::atan(kFriction)}) {
    WorldDescription around{.ground = {world::Slope{.angle = angle}}};
    around.things = {MakeThing("box", kBox, 0.5, {})};
    around.things[0].friction = kFriction;
    world::PutDown(around.ground, 0, 0, {1, 0, 0, 0}, around.things[0]);
    World world = Make(robot, around);
    const Eigen::Vector3d start = Place(world, 0);
    StepFor(world, 1, {});
    const double drive = robot::kGravity * (std::sin(angle) - kFriction * std::cos(angle));
    const double way = std::max(0.0, drive) / 2;
    EXPECT_NEAR((Place(world, 0) - start).norm(), way, 0.03 * way + 0.002) << angle;
  }
}

// The ground's friction limits that of all that touches it.
TEST_P(SurroundingsTest, ABoxSlidesOnSmoothGround) {
  const robot::RobotDescription robot = Marble();
  WorldDescription around{.ground = {world::Slope{.angle = 0.2}, 0.0}};
  around.things = {MakeThing("box", kBox, 0.5, {})};
  world::PutDown(around.ground, 0, 0, {1, 0, 0, 0}, around.things[0]);
  World world = Make(robot, around);
  const Eigen::Vector3d start = Place(world, 0);
  StepFor(world, 1, {});
  EXPECT_NEAR((Place(world, 0) - start).norm(), robot::kGravity * std::sin(0.2) / 2, 0.02);
}

// What they have of momentum stays. How much of the rest is lost lies between all, as in an impact
// without a bounce, and nothing: the depth that they have reached within a step drives them apart.
TEST_P(SurroundingsTest, ARobotThatHitsABallKeepsTheMomentumOfBoth) {
  const robot::RobotDescription robot = Marble({0, 0, 20});
  const WorldDescription around{.things = {MakeThing("ball", kBall, 0.5, {0.4, 0, 20})}};
  robot::StartState start = robot::RestIn(robot.poses[0]);
  start.velocity = {2, 0, 0};
  World world(robot, FindProfile(GetParam()), start, &around);
  StepFor(world, 0.3, {});
  const double marble = dBodyGetLinearVel(world.body().body(0))[0];
  const double ball = Speed(world, 0).x();
  EXPECT_NEAR(1.0 * marble + 0.5 * ball, 2.0, 1e-9);
  EXPECT_GE(ball, 2 / 1.5 - 1e-6);
  EXPECT_LE(ball, 2 * 2 / 1.5 + 1e-6);
  EXPECT_GE(ball, marble - 1e-6);
}

TEST_P(SurroundingsTest, ThingsTellWhichLinksTouchThem) {
  const robot::RobotDescription robot = Marble({0, 0, 0.6});
  WorldDescription around{.things = {MakeThing("table", kBox, 0, {0, 0, 0.25}),
                                     MakeThing("ball", kBall, 0.5, {3, 0, 0.1})}};
  around.things[0].is_fixed = true;
  World world = Make(robot, around);
  EXPECT_FALSE(world.contacts_with(0).flag(0));
  StepFor(world, 1, {});
  EXPECT_TRUE(world.contacts_with(0).flag(0));
  EXPECT_FALSE(world.contacts_with(1).flag(0));
  EXPECT_FALSE(world.contacts().flag(0));  // the table is not the ground
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 0.4, 0.002);
}

TEST_P(SurroundingsTest, ThingsRestOnThings) {
  const robot::RobotDescription robot = Marble();
  const WorldDescription around{.things = {MakeThing("lower", kBox, 2, {0, 0, 0.05}),
                                           MakeThing("upper", kBox, 1, {0.02, 0, 0.17})}};
  World world = Make(robot, around);
  StepFor(world, 1, {});
  EXPECT_NEAR(Place(world, 1).z(), 0.15, 0.002);
  EXPECT_LT(Speed(world, 1).norm(), 0.01);
}

TEST_P(SurroundingsTest, StepsCarryWhatIsOnThem) {
  const robot::RobotDescription robot = Marble({2.25, 0, 0.1});
  WorldDescription around{
      .ground = {world::Steps{.start = 1, .depth = 0.5, .height = 0.2, .count = 4}}};
  around.things = {MakeThing("ball", kBall, 0.5, {1.25, 0, 0.5})};
  World world = Make(robot, around);
  // On the third step, as high above it as above flat ground.
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 0.7, 1e-9);
  StepFor(world, 1, {});
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 0.7, 0.002);
  EXPECT_TRUE(world.contacts().flag(0));
  EXPECT_NEAR(Place(world, 0).z(), 0.3, 0.002);
}

// A groove along y: what lies on its flank comes to rest at its bottom.
WorldDescription Groove() {
  world::HeightMap map{.columns = 5, .rows = 5, .size_x = 4, .size_y = 4};
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) map.heights.push_back(0.5 * std::abs(column - 2));
  }
  return {.ground = {map}};
}

TEST_P(SurroundingsTest, HillsLeadABallToTheirLowestPlace) {
  const robot::RobotDescription robot = Marble({0, 0, 20});
  WorldDescription around = Groove();
  around.things = {MakeThing("ball", kBall, 0.5, {})};
  around.things[0].friction = 0.05;
  world::PutDown(around.ground, 0.6, 0.3, {1, 0, 0, 0}, around.things[0]);
  World world = Make(robot, around);
  StepFor(world, 4, {});
  // Between two planes that rise with 1:2.
  EXPECT_NEAR(Place(world, 0).x(), 0, 0.02);
  EXPECT_NEAR(Place(world, 0).y(), 0.3, 0.05);
  EXPECT_NEAR(Place(world, 0).z(), kBall.radius * std::sqrt(1.25), 0.005);
}

TEST_P(SurroundingsTest, ARobotIsPutDownWithoutReachingIntoTheGround) {
  const WorldDescription slope{.ground = {world::Slope{.angle = 0.2}}};
  const World world(Humanoid(), FindProfile(GetParam()), Humanoid().poses[0], &slope);
  const World flat(Humanoid(), FindProfile(GetParam()), Humanoid().poses[0]);
  const auto deepest = [](const World& of) {
    double depth = 0;
    for (const Contact& contact : of.collision().contacts()) {
      if (std::min(contact.first, contact.second) == Contact::kGround)
        depth = std::max(depth, contact.geometry.depth);
    }
    return depth;
  };
  EXPECT_LE(deepest(world), deepest(flat) + 2e-6);
  EXPECT_FALSE(GroundLinks(world, Humanoid()).empty());
}

bool HaveSameBits(const World& a, const World& b) {
  for (int i = 0; i < a.body().link_count(); ++i) {
    const dBodyID first = a.body().body(i);
    const dBodyID second = b.body().body(i);
    if (std::memcmp(dBodyGetPosition(first), dBodyGetPosition(second), 3 * sizeof(double)) != 0 ||
        std::memcmp(dBodyGetLinearVel(first), dBodyGetLinearVel(second), 3 * sizeof(double)) != 0)
      return false;
  }
  return true;
}

TEST_P(SurroundingsTest, AWorldThatSaysNothingChangesNothing) {
  const WorldDescription nothing;
  World with = Make(Humanoid(), nothing);
  World without(Humanoid(), FindProfile(GetParam()), Humanoid().poses[0]);
  const std::vector<double> targets(Humanoid().joints.size(), 0.2);
  StepFor(with, 0.5, targets);
  StepFor(without, 0.5, targets);
  EXPECT_TRUE(HaveSameBits(with, without));
}

TEST_P(SurroundingsTest, EqualWorldsHaveEqualBits) {
  WorldDescription around = Groove();
  around.things = {MakeThing("ball", kBall, 0.5, {0.5, 0, 1})};
  World first = Make(Humanoid(), around);
  World second = Make(Humanoid(), around);
  StepFor(first, 0.5, Zeros(Humanoid()));
  StepFor(second, 0.5, Zeros(Humanoid()));
  EXPECT_TRUE(HaveSameBits(first, second));
  EXPECT_EQ(Place(first, 0), Place(second, 0));
}

}  // namespace
}  // namespace runtime
