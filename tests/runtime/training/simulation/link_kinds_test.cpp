// What the shapes, inertias and frictions of links do, against what is known of them.
#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "runtime/training/simulation/ground_height.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class LinkKindsTest : public testing::TestWithParam<const char*> {
 protected:
  World Make(const robot::RobotDescription& robot) const {
    return World(robot, FindProfile(GetParam()), robot.poses[0]);
  }
};

INSTANTIATE_TEST_SUITE_P(, LinkKindsTest, testing::ValuesIn(BuiltProfiles()), ProfileInName);

// One link in a pose at this height.
robot::RobotDescription Body(const robot::LinkShape& shape, double height) {
  robot::RobotDescription robot = Rotor();
  robot.links.resize(1);
  robot.links[0].shape = shape;
  robot.joints.clear();
  robot.poses = {{"", {0, 0, height}, {1, 0, 0, 0}, {}}};
  return robot;
}

TEST_P(LinkKindsTest, ACylinderStandsAndLies) {
  const robot::LinkShape standing{robot::ShapeKind::kCylinder, {}, 0.1, 0.3, 2};
  World on_its_end = Make(Body(standing, 0.15));
  StepFor(on_its_end, 0.5, {});
  EXPECT_NEAR(dBodyGetPosition(on_its_end.body().body(0))[2], 0.15, 1e-3);
  robot::LinkShape lying = standing;
  lying.axis = 1;
  World on_its_side = Make(Body(lying, 0.1));
  StepFor(on_its_side, 0.5, {});
  EXPECT_NEAR(dBodyGetPosition(on_its_side.body().body(0))[2], 0.1, 1e-3);
}

TEST_P(LinkKindsTest, ACylinderHasTheInertiaOfOne) {
  const World world = Make(Body({robot::ShapeKind::kCylinder, {}, 0.1, 0.3, 0}, 1));
  dMass mass;
  dBodyGetMass(world.body().body(0), &mass);
  EXPECT_NEAR(mass.I[0], 0.5 * 0.1 * 0.1, 1e-15);
  EXPECT_NEAR(mass.I[5], (3 * 0.1 * 0.1 + 0.3 * 0.3) / 12, 1e-15);
}

TEST_P(LinkKindsTest, AStartPutsAnyShapeOnTheGround) {
  for (const int axis : {0, 1, 2}) {
    robot::LinkShape shape{robot::ShapeKind::kCylinder, {}, 0.1, 0.3, axis};
    shape.position = {0.05, 0, -0.2};
    shape.orientation = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};  // x to -z, z to x
    const robot::RobotDescription robot = Body(shape, 0);
    const double reach = axis == 0 ? 0.15 : 0.1;
    EXPECT_NEAR(LowestPoint(robot, robot.poses[0]), -0.2 - reach, 1e-12) << axis;
  }
}

// The corners of a box, some points on its faces and within.
robot::LinkShape CornersOfABox(const robot::Vector3& half) {
  robot::LinkShape shape;
  shape.kind = robot::ShapeKind::kConvex;
  for (int corner = 0; corner < 8; ++corner) {
    shape.points.push_back({corner & 1 ? half[0] : -half[0], corner & 2 ? half[1] : -half[1],
                            corner & 4 ? half[2] : -half[2]});
  }
  for (int i = 0; i < 30; ++i) shape.points.push_back({half[0] * std::sin(i), 0, -half[2]});
  return shape;
}

robot::RobotDescription ConvexBody(const robot::Vector3& half, double height) {
  robot::RobotDescription robot = Body(CornersOfABox(half), height);
  const auto moment = [&](double a, double b) { return robot.links[0].mass * (a * a + b * b) / 3; };
  robot.links[0].inertia =
      robot::Inertia{moment(half[1], half[2]), moment(half[0], half[2]), moment(half[0], half[1])};
  return robot;
}

TEST_P(LinkKindsTest, AConvexLinkMovesAsTheBoxThatItIs) {
  const robot::Vector3 half = {0.1, 0.2, 0.05};
  robot::RobotDescription convex = ConvexBody(half, 0.4);
  robot::RobotDescription box = Body({robot::ShapeKind::kBox, {0.2, 0.4, 0.1}}, 0.4);
  for (robot::RobotDescription* robot : {&convex, &box})
    robot->poses[0].orientation = {std::cos(0.2), std::sin(0.2), 0, 0};
  World one = Make(convex);
  World other = Make(box);
  StepFor(one, 0.2, {});  // in the air
  StepFor(other, 0.2, {});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(dBodyGetPosition(one.body().body(0))[i], dBodyGetPosition(other.body().body(0))[i],
                1e-9);
  }
  StepFor(one, 1.5, {});  // fallen on its flat side
  StepFor(other, 1.5, {});
  EXPECT_NEAR(dBodyGetPosition(one.body().body(0))[2], 0.05, 1e-3);
  EXPECT_NEAR(dBodyGetPosition(other.body().body(0))[2], 0.05, 1e-3);
  EXPECT_NEAR(dBodyGetRotation(one.body().body(0))[10], 1, 1e-4);  // z is up again
}

TEST_P(LinkKindsTest, AConvexLinkStartsOnTheGround) {
  robot::RobotDescription robot = ConvexBody({0.1, 0.2, 0.05}, 0);
  robot.links[0].shape.position = {0, 0, -0.3};
  EXPECT_NEAR(LowestPoint(robot, robot.poses[0]), -0.35, 1e-12);
}

TEST_P(LinkKindsTest, ConvexLinksTouchEachOtherAndOtherShapes) {
  for (const robot::LinkShape& other :
       {CornersOfABox({0.1, 0.1, 0.1}), robot::LinkShape{robot::ShapeKind::kSphere, {}, 0.1},
        robot::LinkShape{robot::ShapeKind::kCapsule, {}, 0.1, 0.3, 0},
        robot::LinkShape{robot::ShapeKind::kCylinder, {}, 0.1, 0.2, 2},
        robot::LinkShape{robot::ShapeKind::kBox, {0.2, 0.2, 0.2}}}) {
    robot::RobotDescription robot = ConvexBody({0.1, 0.2, 0.05}, 5);
    robot.links.resize(2, robot.links[0]);
    robot.links[1].shape = other;
    robot.links[1].inertia = robot.links[0].inertia;
    robot.links[1].position = {0, 0, 0.14};  // 1 cm within the first
    robot.mounts = {{.name = "pin",
                     .kind = robot::MountKind::kBall,
                     .parent = 0,
                     .child = 1,
                     .anchor = {0, 0, 0.1}}};
    robot.links.push_back(robot.links[1]);  // a third hangs on the second and touches the first
    robot.mounts.push_back({.name = "hook",
                            .kind = robot::MountKind::kBall,
                            .parent = 1,
                            .child = 2,
                            .anchor = {0, 0, 0.2}});
    for (size_t i = 0; i < robot.links.size(); ++i)
      robot.links[i].name = "link" + std::to_string(i);
    World world = Make(robot);
    world.Step({});
    bool touches = false;
    for (const Contact& contact : world.collision().contacts())
      touches = touches || (contact.first == 0 && contact.second == 2);
    EXPECT_TRUE(touches) << static_cast<int>(other.kind);
  }
}

// A body whose shape hangs beside its center of mass falls without turning, and turns in the air as
// its own inertia says.
TEST_P(LinkKindsTest, AnOffCenterBodyFallsAndTurnsAboutItsCenterOfMass) {
  robot::RobotDescription robot = Body({robot::ShapeKind::kSphere, {}, 0.05}, 10);
  robot.links[0].shape.position = {0.3, 0, 0};
  robot.links[0].inertia = robot::Inertia{0.02, 0.02, 0.01, 0.005, 0, 0};
  World world = Make(robot);
  dBodySetAngularVel(world.body().body(0), 0, 0, 3);  // about a principal axis
  StepFor(world, 0.5, {});
  const dReal* position = dBodyGetPosition(world.body().body(0));
  EXPECT_NEAR(position[0], 0, 1e-9);
  EXPECT_NEAR(position[2], 10 - robot::kGravity * 0.125, 0.01);
  const dReal* turning = dBodyGetAngularVel(world.body().body(0));
  EXPECT_NEAR(turning[0], 0, 1e-6);
  EXPECT_NEAR(turning[2], 3, 1e-6);
}

// Free rotation about no principal axis keeps the angular momentum.
TEST_P(LinkKindsTest, ATurningBodyKeepsItsAngularMomentum) {
  robot::RobotDescription robot = Body({robot::ShapeKind::kSphere, {}, 0.05}, 10);
  robot.links[0].inertia = robot::Inertia{0.02, 0.025, 0.03, 0.004, -0.003, 0.002};
  World world = Make(robot);
  dBodySetAngularVel(world.body().body(0), 1, 2, 3);
  const auto momentum = [&] {
    const dBodyID body = world.body().body(0);
    const robot::Inertia& m = *robot.links[0].inertia;
    Matrix3 inertia;
    inertia << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
    const Matrix3 rotation = RotationOf(body);
    return Vector3(rotation * inertia * rotation.transpose() * ToEigen(dBodyGetAngularVel(body)));
  };
  const Vector3 before = momentum();
  StepFor(world, 0.2, {});
  EXPECT_LT((momentum() - before).norm(), 20 * world.physics_time_step() * before.norm());
}

// A box on the ground that begins with this speed along x.
World Sliding(double friction, const char* profile) {
  static robot::RobotDescription robot;  // outlives the worlds
  robot = Body({robot::ShapeKind::kBox, {0.2, 0.2, 0.02}}, 0.01);
  robot.links[0].friction = friction;
  robot::StartState start = robot::RestIn(robot.poses[0]);
  start.velocity = {1, 0, 0};
  return World(robot, FindProfile(profile), start);
}

TEST_P(LinkKindsTest, FrictionBringsASlidingBodyToRest) {
  World world = Sliding(0.3, GetParam());
  StepFor(world, 0.2, {});
  EXPECT_NEAR(dBodyGetLinearVel(world.body().body(0))[0], 1 - 0.3 * robot::kGravity * 0.2, 0.03);
  StepFor(world, 0.5, {});
  EXPECT_NEAR(dBodyGetLinearVel(world.body().body(0))[0], 0, 1e-3);
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[0], 1 / (2 * 0.3 * robot::kGravity), 0.02);
}

TEST_P(LinkKindsTest, NothingHoldsABodyWithoutFriction) {
  World world = Sliding(0, GetParam());
  StepFor(world, 0.5, {});
  EXPECT_NEAR(dBodyGetLinearVel(world.body().body(0))[0], 1, 1e-6);
}

// A block on the inclined top of a body that does not move: it slides from the angle of friction
// on.
TEST_P(LinkKindsTest, ABlockSlidesDownASlopeThatIsSteepEnough) {
  for (const double friction : {0.2, 0.5}) {
    const double angle = std::atan(0.35);
    robot::RobotDescription robot = Rotor();
    robot.has_fixed_base = true;
    robot.links[0].shape = {robot::ShapeKind::kBox, {2, 2, 0.2}};
    robot.links[1].shape = {robot::ShapeKind::kBox, {0.2, 0.2, 0.1}};
    robot.links[1].position = {0, 0, 0.15};
    robot.links[0].friction = robot.links[1].friction = friction;
    // Between the two a rail without a motor that only guides, and a link that lets it.
    robot.links.push_back({"guide", 1e-3, {0, 0, 0.5}, {robot::ShapeKind::kSphere, {}, 0.01}});
    robot.joints = {{"down", 0, 2, {1, 0, 0}, {}, -5, 5}, {"onto", 2, 1, {0, 0, 1}, {}, -5, 5}};
    for (robot::Joint& joint : robot.joints) {
      joint.kind = robot::JointKind::kSlider;
      joint.gains = {.stiffness = 0, .damping = 0, .max_torque = 0, .max_speed = {}};
    }
    robot.poses = {{"", {0, 0, 5}, {std::cos(angle / 2), 0, std::sin(angle / 2), 0}, {0, 0}}};
    World world = Make(robot);
    StepFor(world, 0.5, {0, 0});
    const double pull = robot::kGravity * (std::sin(angle) - friction * std::cos(angle));
    const double speed = std::max(0.0, pull) * 0.5;
    EXPECT_NEAR(world.body().joint(0).Rate(), speed, 0.05) << friction;
  }
}

TEST_P(LinkKindsTest, ExcludedLinksDoNotTouch) {
  robot::RobotDescription humanoid = Humanoid();
  robot::Pose pose = humanoid.poses[1];
  for (size_t j = 0; j < pose.joint_angles.size(); ++j) {
    pose.joint_angles[j] = 0.4 * humanoid.joints[j].high;  // limbs within each other
  }
  const auto touching = [&] {
    World world(humanoid, FindProfile(GetParam()), pose);
    std::vector<std::array<int, 2>> pairs;
    for (const Contact& contact : world.collision().contacts()) {
      if (contact.first != Contact::kGround && contact.second != Contact::kGround)
        pairs.push_back({contact.first, contact.second});
    }
    return pairs;
  };
  const std::vector<std::array<int, 2>> before = touching();
  ASSERT_FALSE(before.empty());
  humanoid.contact_exclusions = before;
  EXPECT_THAT(touching(), ElementsAre());
}

}  // namespace
}  // namespace runtime
