// What only the second engine has: its model of a robot, and how far it agrees with the paper's
// simulation. What all engines share is tested with the others, by profile.
#include <gmock/gmock.h>

#include <cmath>

#include "runtime/base/user_error.h"
#include "runtime/training/simulation/mujoco_model.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Property;

const Profile& Mujoco() { return FindProfile("mujoco"); }

Mjcf TextOf(const robot::RobotDescription& robot, const world::WorldDescription* around = nullptr) {
  const World world(robot, FindProfile("fast-tree"), robot.poses[0], around);
  return MjcfOf(robot, world.surroundings(), {.time_step = 0.0025, .contacts = {}}, world.body());
}

TEST(Mujoco, TheModelHasTheNamesOfTheRobot) {
  const auto model = CompiledModel(TextOf(Humanoid()));
  EXPECT_EQ(model->nv, 6 + 17);
  EXPECT_EQ(model->nu, 0);
  EXPECT_EQ(mj_name2id(model.get(), mjOBJ_JOINT, "left_knee_pitch"), 1 + 9);
  double mass = 0;
  for (const robot::Link& link : Humanoid().links) {
    const int id = mj_name2id(model.get(), mjOBJ_BODY, link.name.c_str());
    ASSERT_GE(id, 1) << link.name;
    EXPECT_DOUBLE_EQ(model->body_mass[id], link.mass) << link.name;
    mass += model->body_mass[id];
  }
  EXPECT_NEAR(mass, 1.2, 1e-9);
}

TEST(Mujoco, TheSameModelIsMadeOnce) {
  const auto model = CompiledModel(TextOf(Humanoid()));
  EXPECT_EQ(CompiledModel(TextOf(Humanoid())), model);
  EXPECT_NE(CompiledModel(TextOf(Hopper())), model);
}

TEST(Mujoco, AnImpossibleInertiaIsNamedAndAThinPlateIsNone) {
  robot::RobotDescription robot = Rotor();
  robot.links[1].inertia = robot::Inertia{0.01, 0.02, 0.03};
  EXPECT_NO_THROW(World(robot, Mujoco(), robot.poses[0]));
  robot.links[1].inertia = robot::Inertia{0.01, 0.02, 0.04};
  EXPECT_THAT([&] { World(robot, Mujoco(), robot.poses[0]); },
              testing::Throws<UserError>(Property(
                  &UserError::what,
                  AllOf(HasSubstr("the link `wheel`"), HasSubstr("0.01, 0.02 and 0.04")))));
}

TEST(Mujoco, WhatItRefusesIsSaidInItsWords) {
  robot::RobotDescription robot = Rotor();
  robot.links[1].name = "world";
  EXPECT_THAT([&] { World(robot, Mujoco(), robot.poses[0]); },
              testing::Throws<UserError>(Property(
                  &UserError::what,
                  AllOf(HasSubstr("MuJoCo cannot simulate this robot"), HasSubstr("world")))));
}

// The heights of hills are in the model as the world has them, whatever its lowest and highest are.
TEST(Mujoco, TheModelHasTheHillsOfTheWorld) {
  world::HeightMap map{.columns = 3, .rows = 2, .size_x = 4, .size_y = 2, .center_x = 5};
  map.heights = {0.5, 0.25, 0.75, 1.25, 0.5, 0.5};
  const world::WorldDescription around{.ground = {map}};
  const auto model = CompiledModel(TextOf(Humanoid(), &around));
  ASSERT_EQ(model->nhfield, 1);
  ASSERT_EQ(model->hfield_nrow[0], 2);
  ASSERT_EQ(model->hfield_ncol[0], 3);
  const int geom = mj_name2id(model.get(), mjOBJ_GEOM, "ground hills");
  ASSERT_GE(geom, 0);
  EXPECT_EQ(model->geom_pos[3 * geom], 5);
  for (size_t i = 0; i < map.heights.size(); ++i) {
    EXPECT_NEAR(model->geom_pos[3 * geom + 2] + model->hfield_size[2] * model->hfield_data[i],
                map.heights[i], 1e-6);
  }
}

TEST(Mujoco, HillsThatAreLevelAreHighAsTheyAre) {
  world::HeightMap map{.columns = 2, .rows = 2, .size_x = 4, .size_y = 4};
  map.heights = {0.5, 0.5, 0.5, 0.5};
  const world::WorldDescription around{.ground = {map}};
  World world(Humanoid(), Mujoco(), Humanoid().poses[0], &around);
  StepFor(world, 0.5, Zeros(Humanoid()));
  EXPECT_NEAR(dBodyGetPosition(world.body().body(0))[2], 0.5 + Humanoid().poses[0].position[2],
              0.005);
}

// Names of things are no names of the robot's, whatever they are called.
TEST(Mujoco, AThingMayBeCalledAsALinkIs) {
  world::Thing thing;
  thing.name = Humanoid().links[0].name;
  thing.shape = {.kind = robot::ShapeKind::kSphere, .radius = 0.1};
  thing.mass = 1;
  thing.position = {3, 0, 0.1};
  const world::WorldDescription around{.things = {thing}};
  World world(Humanoid(), Mujoco(), Humanoid().poses[0], &around);
  StepFor(world, 0.1, Zeros(Humanoid()));
  EXPECT_FALSE(world.contacts_with(0).flag(0));
}

// The joints' angles of a robot in the air that follows its targets.
TEST(Mujoco, MovesAsThePaperDoesInTheAir) {
  robot::Pose pose = Humanoid().poses[0];
  pose.position[2] = 100;
  World paper(Humanoid(), FindProfile("paper-tree"), pose);
  World other(Humanoid(), Mujoco(), pose);
  std::vector<double> targets = Zeros(Humanoid());
  for (const int j : {1, 4, 8, 13}) targets[j] = 0.4;
  for (const int j : {9, 14}) targets[j] = -0.4;
  for (int i = 0; i < 10; ++i) {
    StepFor(paper, 0.05, targets);
    StepFor(other, 0.05, targets);
    for (int j = 0; j < 17; ++j) {
      EXPECT_NEAR(other.body().JointAngle(j), paper.body().JointAngle(j), 0.03)
          << i << " " << Humanoid().joints[j].name;
    }
  }
}

// The force of the ground on each foot, once the robot stands still.
TEST(Mujoco, CarriesTheWeightAsThePaperDoes) {
  const auto forces = [](const Profile& profile) {
    World world(Humanoid(), profile, Humanoid().poses[0]);
    StepFor(world, 2, Zeros(Humanoid()));
    world.StartTimeStep({.contact_forces = true});
    for (int i = 0; i < world.physics_steps_per_time_step(); ++i) world.Step(Zeros(Humanoid()));
    return std::array{world.means().ContactForce(Humanoid().FindLink("left_foot").value()),
                      world.means().ContactForce(Humanoid().FindLink("right_foot").value())};
  };
  const auto paper = forces(FindProfile("paper-tree"));
  const auto other = forces(Mujoco());
  const double weight = 1.2 * robot::kGravity;
  EXPECT_NEAR(other[0].z() + other[1].z(), weight, 1e-3 * weight);
  for (size_t foot = 0; foot < 2; ++foot) {
    EXPECT_NEAR(other[foot].z(), paper[foot].z(), 0.01 * weight) << foot;
  }
}

// Pushed over in each of eight directions, it comes to lie as it does there.
TEST(Mujoco, FallsAsThePaperDoes) {
  const auto height_at_end = [](const Profile& profile, double direction) {
    robot::StartState start = robot::RestIn(Humanoid().poses[0]);
    start.velocity = {std::cos(direction), std::sin(direction), 0};
    World world(Humanoid(), profile, start);
    StepFor(world, 1.5, Zeros(Humanoid()));
    return dBodyGetPosition(world.body().body(0))[2];
  };
  for (int i = 0; i < 8; ++i) {
    const double direction = 2 * M_PI * i / 8;
    const double height = height_at_end(FindProfile("paper-tree"), direction);
    EXPECT_LT(height, 0.15) << i;
    EXPECT_NEAR(height_at_end(Mujoco(), direction), height, 0.01) << i;
  }
}

}  // namespace
}  // namespace runtime
