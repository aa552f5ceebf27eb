#include "runtime/training/simulation/collision.h"

#include <gmock/gmock.h>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

World At(const robot::RobotDescription& robot, robot::Pose pose) {
  return World(robot, FindProfile("paper"), pose);
}

TEST(Collision, AStandingRobotTouchesTheGroundWithTheCornersOfItsFeet) {
  const World world = At(Humanoid(), Humanoid().poses[0]);
  EXPECT_EQ(world.collision().contacts().size(), 8);
  EXPECT_THAT(GroundLinks(world, Humanoid()), ElementsAre("left_foot", "right_foot"));
}

TEST(Collision, ARobotInTheAirTouchesNothing) {
  robot::Pose pose = Humanoid().poses[0];
  pose.position[2] += 1e-6;
  const World world = At(Humanoid(), pose);
  EXPECT_EQ(world.collision().contacts().size(), 0);
  EXPECT_THAT(GroundLinks(world, Humanoid()), IsEmpty());
}

TEST(Collision, LinksOnAJointDoNotCollide) {
  // The hopper's thigh overlaps the trunk and the shank.
  robot::Pose pose = Hopper().poses[0];
  pose.position[2] = 1;
  EXPECT_EQ(At(Hopper(), pose).collision().contacts().size(), 0);
}

TEST(Collision, OtherLinksOfTheRobotCollide) {
  robot::RobotDescription robot = Hopper();
  robot.links[2].position[2] = -0.26;  // as far below the knee as the trunk is above it
  robot::Pose pose = robot.poses[0];
  pose.position[2] = 1;
  pose.joint_angles = {0, -3};  // folds the shank up into the trunk
  const World world = At(robot, pose);
  EXPECT_GT(world.collision().contacts().size(), 0);
  EXPECT_THAT(GroundLinks(world, robot), IsEmpty());
}

TEST(Collision, CapsulesLieAlongTheirAxes) {
  // The left shoulder lies along y: half its length of 0.02961 to the side, its radius of 0.012 to
  // every other side.
  const World world = At(Humanoid(), Humanoid().poses[0]);
  dReal box[6];
  dGeomGetAABB(world.body().geom(2), box);
  EXPECT_NEAR(box[1] - box[0], 2 * 0.012, 1e-12);
  EXPECT_NEAR(box[3] - box[2], 0.02961, 1e-12);
  EXPECT_NEAR(box[5] - box[4], 2 * 0.012, 1e-12);
  // And so does its mass.
  dMass mass;
  dBodyGetMass(world.body().body(2), &mass);
  EXPECT_LT(mass.I[5], mass.I[0]);
  EXPECT_DOUBLE_EQ(mass.I[0], mass.I[10]);
}

}  // namespace
}  // namespace runtime
