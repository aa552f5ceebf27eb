#include "runtime/training/simulation/tree_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

// Makes all links of a world lie and move as those of another.
void CopyState(const World& from, const World& to) {
  for (int i = 0; i < from.body().body_count(); ++i) {
    const dBodyID source = from.body().body(i);
    const dBodyID target = to.body().body(i);
    const dReal* p = dBodyGetPosition(source);
    const dReal* v = dBodyGetLinearVel(source);
    const dReal* w = dBodyGetAngularVel(source);
    dBodySetPosition(target, p[0], p[1], p[2]);
    dBodySetQuaternion(target, dBodyGetQuaternion(source));
    dBodySetLinearVel(target, v[0], v[1], v[2]);
    dBodySetAngularVel(target, w[0], w[1], w[2]);
  }
}

// The largest difference in any component of a link's motion, relative to the fastest one.
double Difference(const World& a, const World& b) {
  double difference = 0;
  double largest = 1e-3;
  const auto compare = [&](const dReal* first, const dReal* second, int count) {
    for (int k = 0; k < count; ++k) {
      difference = std::max(difference, std::abs(first[k] - second[k]));
      largest = std::max(largest, std::abs(first[k]));
    }
  };
  for (int i = 0; i < a.body().body_count(); ++i) {
    const dBodyID first = a.body().body(i);
    const dBodyID second = b.body().body(i);
    compare(dBodyGetLinearVel(first), dBodyGetLinearVel(second), 3);
    compare(dBodyGetAngularVel(first), dBodyGetAngularVel(second), 3);
    compare(dBodyGetPosition(first), dBodyGetPosition(second), 3);
    compare(dBodyGetQuaternion(first), dBodyGetQuaternion(second), 4);
  }
  return difference / largest;
}

// What happened in the steps that were compared: the difference means little if nothing did.
struct Seen {
  double difference = 0;
  int ground_contacts = 0;
  int link_contacts = 0;
  int stops = 0;
  int full_torques = 0;
  std::string failure;  // what ended the motion before its time

  void Add(const World& world, const robot::RobotDescription& robot) {
    for (const Contact& contact : world.collision().contacts()) {
      const bool ground = contact.first == Contact::kGround || contact.second == Contact::kGround;
      ++(ground ? ground_contacts : link_contacts);
    }
    for (size_t j = 0; j < robot.joints.size(); ++j) {
      const double angle = world.controller().angles()[j];
      stops += angle <= robot.joints[j].low || angle >= robot.joints[j].high;
      full_torques +=
          std::abs(world.controller().torques()[j]) == robot.GainsOf(robot.joints[j]).max_torque;
    }
  }
};

struct Pair {
  const char* by_ode;
  const char* by_tree;
};

class TreeSolverTest : public testing::TestWithParam<Pair> {
 protected:
  // Every step of ODE's from where ODE has got to, with a new random posture every 0.2 s, as long
  // as that is a robot's motion.
  Seen Compare(const robot::RobotDescription& robot, const robot::Pose& pose, double seconds,
               const world::WorldDescription* around = nullptr) {
    World ode(robot, FindProfile(GetParam().by_ode), pose, around);
    World tree(robot, FindProfile(GetParam().by_tree), pose, around);
    std::mt19937 random(1);
    std::vector<double> targets = Zeros(robot);
    const int steps_in_a_posture = static_cast<int>(0.2 / ode.physics_time_step());
    const int steps = static_cast<int>(seconds / ode.physics_time_step());
    Seen seen;
    for (int step = 0; step < steps; ++step) {
      if (step % steps_in_a_posture == 0) {
        for (size_t j = 0; j < targets.size(); ++j) {
          const robot::Joint& joint = robot.joints[j];
          constexpr double kFarthest = 20;  // of a joint without stops [rad]
          targets[j] = std::uniform_real_distribution(std::max(joint.low, -kFarthest),
                                                      std::min(joint.high, kFarthest))(random);
        }
      }
      CopyState(ode, tree);
      try {
        ode.Step(targets);
        tree.Step(targets);
      } catch (const OdeFailure& failure) {
        seen.failure = failure.what();
        break;
      }
      seen.Add(tree, robot);
      seen.difference = std::max(seen.difference, Difference(ode, tree));
    }
    return seen;
  }
};

INSTANTIATE_TEST_SUITE_P(, TreeSolverTest,
                         testing::Values(Pair{"paper", "paper-tree"}, Pair{"fast", "fast-tree"}),
                         [](const auto& instance) { return std::string(instance.param.by_ode); });

// ODE's own rounding is of this size: the same step of the robot turned about the vertical axis
// differs by 1e-11.
constexpr double kRounding = 1e-9;

TEST_P(TreeSolverTest, EveryStepIsOdesUpToRounding) {
  Seen all;
  for (const robot::Pose& pose : Humanoid().poses) {
    const Seen seen = Compare(Humanoid(), pose, 2);
    EXPECT_LT(seen.difference, kRounding) << pose.name;
    all.ground_contacts += seen.ground_contacts;
    all.link_contacts += seen.link_contacts;
    all.stops += seen.stops;
    all.full_torques += seen.full_torques;
  }
  EXPECT_GT(all.ground_contacts, 1000);
  EXPECT_GT(all.link_contacts, 300);
  EXPECT_GT(all.stops, 50);
  EXPECT_GT(all.full_torques, 1000);
}

TEST_P(TreeSolverTest, OtherRobotsMoveAsByOdeToo) {
  EXPECT_LT(Compare(Hopper(), Hopper().poses[0], 2).difference, kRounding);
  const robot::RobotDescription rotor = Rotor();
  EXPECT_LT(Compare(rotor, rotor.poses[0], 0.5).difference, kRounding);
}

// Every kind of joint, with all that it can have.
TEST_P(TreeSolverTest, EveryKindOfJointMovesAsByOdeToo) {
  for (const bool is_fixed : {false, true}) {
    robot::RobotDescription robot = Tinker();
    robot.has_fixed_base = is_fixed;
    for (robot::Pose& pose : robot.poses) {
      pose.joint_angles[1] = robot.joints[1].high + 0.02;
      const Seen seen = Compare(robot, pose, 0.4);
      EXPECT_LT(seen.difference, kRounding) << pose.name << is_fixed;
      EXPECT_GT(seen.stops, 0);
      EXPECT_EQ(seen.failure, "") << pose.name << is_fixed;
    }
  }
}

// Shapes off the centers of mass, inertias of their own, and friction that gives way.
TEST_P(TreeSolverTest, EveryKindOfLinkMovesAsByOdeToo) {
  Seen all;
  for (const robot::Pose& pose : Blocks().poses) {
    const Seen seen = Compare(Blocks(), pose, 1);
    EXPECT_LT(seen.difference, kRounding) << pose.name;
    EXPECT_EQ(seen.failure, "") << pose.name;
    all.ground_contacts += seen.ground_contacts;
  }
  EXPECT_GT(all.ground_contacts, 300);
}

// Things that are pushed about, on stairs and on a slope, with friction that gives way and without.
TEST_P(TreeSolverTest, ThingsMoveAsByOdeToo) {
  const robot::LinkShape ball{.kind = robot::ShapeKind::kSphere, .radius = 0.04};
  const robot::LinkShape box{.kind = robot::ShapeKind::kBox, .size = {0.1, 0.2, 0.06}};
  world::WorldDescription around;
  around.things = {{.name = "ball", .shape = ball, .mass = 0.05, .friction = 0.5},
                   {.name = "box", .shape = box, .mass = 0.3},
                   {.name = "post", .shape = box, .is_fixed = true}};
  around.things[0].position = {0.12, 0.02, 0.05};
  around.things[1].position = {-0.15, 0, 0.03};
  around.things[2].position = {0.02, 0.2, 0.03};
  for (const world::Ground& ground :
       {world::Ground{world::Steps{0.2, 0.1, 0.02, 3}}, world::Ground{world::Slope{0.1, 1}, 0.9}}) {
    around.ground = ground;
    const Seen seen = Compare(Humanoid(), Humanoid().poses[0], 2, &around);
    EXPECT_LT(seen.difference, kRounding);
    EXPECT_EQ(seen.failure, "");
    EXPECT_GT(seen.link_contacts, 100);
    EXPECT_GT(seen.ground_contacts, 1000);
  }
}

TEST_P(TreeSolverTest, ACrumpledRobotMovesAsByOdeToo) {
  int link_contacts = 0;
  for (double share = 0.303; share < 0.8; share += 0.01) {
    robot::Pose pose = Humanoid().poses[1];
    for (size_t j = 0; j < pose.joint_angles.size(); ++j) {
      pose.joint_angles[j] = share * Humanoid().joints[j].high;  // limbs within each other
    }
    pose.position[2] += 0.1;
    const Seen seen = Compare(Humanoid(), pose, 0.05);
    EXPECT_LT(seen.difference, kRounding) << share;
    link_contacts += seen.link_contacts;
  }
  EXPECT_GT(link_contacts, 300);
}

}  // namespace
}  // namespace runtime
