// A robot starts as a task says.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "runtime/training/simulation/ground_height.h"
#include "runtime/training/simulation/robot_environment.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

class StartTest : public testing::TestWithParam<const char*> {
 protected:
  StartTest() {
    environment_.Set("profile", std::string(GetParam()));
    environment_.Start();
  }

  static robot::StartState In(const char* pose) {
    return robot::RestIn(*Humanoid().FindPose(pose));
  }
  // All kinds of changes at once.
  static robot::StartState Moving() {
    robot::StartState start = In("standing");
    for (size_t i = 0; i < start.joint_velocities.size(); ++i) {
      start.pose.joint_angles[i] += 0.02 * static_cast<double>(i % 5) - 0.04;
      start.joint_velocities[i] = 0.3 * static_cast<double>(i % 3) - 0.2;
    }
    start.pose.position[0] = 0.5;
    start.pose.position[2] += 0.05;
    start.velocity = {0.3, -0.1, 0.2};
    start.angular_velocity = {0.5, 0.25, -1};
    return start;
  }

  std::vector<double> Read(const char* sensor, size_t count) {
    const double* reals = static_cast<SensorOut&>(environment_.FindPort(sensor))().reals();
    return {reals, reals + count};
  }
  double LowestInSimulation() {
    std::vector<float> pose(7 * static_cast<size_t>(environment_.pose_count()));
    environment_.CapturePose(pose);
    robot::Pose base;
    base.joint_angles = Read("joint.angle", Humanoid().joints.size());
    for (size_t i = 0; i < 3; ++i) base.position[i] = Read("base.position", 3)[i];
    for (size_t i = 0; i < 4; ++i) base.orientation[i] = Read("base.orientation", 4)[i];
    return LowestPoint(Humanoid(), base);
  }
  void RunFor(double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / environment_.time_step()));
    for (int i = 0; i < steps; ++i) environment_.RunTimeStep();
  }

  RobotEnvironment environment_{"environment", Context{&Humanoid(), {}, 0}};
};

void ExpectNear(const std::vector<double>& is, std::span<const double> wanted, const char* what) {
  for (size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i], wanted[i], 1e-9) << what << " " << i;
}

TEST_P(StartTest, BeginsWithTheseAnglesAndVelocities) {
  const robot::StartState start = Moving();
  environment_.StartEpisode(start);
  const size_t joints = Humanoid().joints.size();
  ExpectNear(Read("joint.angle", joints), start.pose.joint_angles, "angle");
  ExpectNear(Read("joint.velocity", joints), start.joint_velocities, "velocity");
  ExpectNear(Read("base.velocity", 3), start.velocity, "base.velocity");
  ExpectNear(Read("base.angular_velocity", 3), start.angular_velocity, "base.angular_velocity");
}

// The hinges hold: no link is driven apart from its neighbor.
TEST_P(StartTest, StaysInOnePieceAndFinite) {
  environment_.StartEpisode(Moving());
  RunFor(1);
  EXPECT_NEAR(environment_.time(), 1, 1e-9);
  for (const double angle : Read("joint.angle", Humanoid().joints.size()))
    EXPECT_TRUE(std::isfinite(angle));
  EXPECT_LT(std::abs(Read("base.position", 3)[2]), 0.5);
}

TEST_P(StartTest, TouchesTheGroundAsInThePose) {
  for (const char* pose : {"standing", "lying", "sitting"}) {
    robot::StartState start = In(pose);
    const double clearance = LowestPoint(Humanoid(), start.from);
    start.pose.joint_angles[3] += 0.2;
    start.pose.orientation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // on its side
    environment_.StartEpisode(start);
    EXPECT_NEAR(LowestInSimulation(), clearance, 1e-9) << pose;
    start.pose.position[2] += 0.1;
    environment_.StartEpisode(start);
    EXPECT_NEAR(LowestInSimulation(), clearance + 0.1, 1e-9) << pose;
    start.pose.position[2] -= 0.3;  // never below
    environment_.StartEpisode(start);
    EXPECT_NEAR(LowestInSimulation(), clearance, 1e-9) << pose;
  }
}

TEST_P(StartTest, OfAPoseAtRestIsThePoseBitForBit) {
  for (const robot::Pose& pose : Humanoid().poses) {
    environment_.Set("start_pose", pose.name);
    environment_.StartEpisode();
    RunFor(0.1);
    const std::vector<double> position = Read("base.position", 3);
    environment_.Set("start_pose", std::string());
    environment_.StartEpisode(robot::RestIn(pose));
    RunFor(0.1);
    EXPECT_EQ(Read("base.position", 3), position) << pose.name;
  }
}

TEST_P(StartTest, AStartPoseOfTheAgentComesFirst) {
  environment_.Set("start_pose", std::string("lying"));
  environment_.StartEpisode(In("standing"));
  EXPECT_LT(Read("base.position", 3)[2], 0.1);
}

INSTANTIATE_TEST_SUITE_P(Profiles, StartTest, testing::Values("paper", "fast", "fast-tree"),
                         ProfileInName);

TEST(GroundHeight, IsThatOfTheLowestPointOfAnyShape) {
  robot::RobotDescription robot;
  robot.links = {{.name = "box", .position = {}, .shape = {robot::ShapeKind::kBox, {2, 4, 6}}},
                 {.name = "ball",
                  .position = {0, 0, 1},
                  .shape = {.kind = robot::ShapeKind::kSphere, .radius = 0.5}}};
  robot.joints = {{.name = "hinge", .parent = 0, .child = 1, .axis = {1, 0, 0}, .anchor = {}}};
  robot::Pose pose{"any", {0, 0, 10}, {1, 0, 0, 0}, {0}};
  EXPECT_NEAR(LowestPoint(robot, pose), 7, 1e-12);
  pose.orientation = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // about x: y is up
  EXPECT_NEAR(LowestPoint(robot, pose), 8, 1e-12);
  robot.links[1].shape = {
      .kind = robot::ShapeKind::kCapsule, .radius = 0.5, .length = 21, .axis = 1};
  EXPECT_NEAR(LowestPoint(robot, pose), -0.5, 1e-12);
}

}  // namespace
}  // namespace runtime
