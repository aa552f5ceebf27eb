// How a task draws the first state of an episode.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "runtime/core/task/universal_task.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

robot::RobotDescription Poser() {
  robot::RobotDescription robot = Walker();
  for (robot::Joint& joint : robot.joints) {
    joint.name = "knee";
    joint.low = -1;
    joint.high = 2;
  }
  robot.poses = {{"first", {1, 2, 3}, {1, 0, 0, 0}, {0.5, 0.5}},
                 {"second", {4, 5, 6}, {0, 1, 0, 0}, {1, 1}}};
  return robot;
}

class StartTest : public testing::Test {
 protected:
  std::unique_ptr<UniversalTask> MakeTask(uint64_t seed) {
    return std::make_unique<UniversalTask>(
        "task", robot_, std::make_unique<TaskInstance>(LoadTask("starts")), seed);
  }

  robot::RobotDescription robot_ = Poser();
};

TEST_F(StartTest, IsThatOfThePoseWithWhatTheTaskChanges) {
  const auto task = MakeTask(1);
  std::set<double> speeds;
  for (int64_t episode = 1; episode <= 20; ++episode) {
    task->SetNextEpisode(episode);
    const robot::StartState start = task->DrawStart().value();
    const bool is_second = start.velocity[0] == 1;
    const robot::Pose& from = robot_.poses[is_second ? 1 : 0];
    EXPECT_EQ(start.from.name, from.name);
    EXPECT_EQ(start.pose.position, from.position);
    EXPECT_THAT(start.pose.joint_angles,
                ElementsAre(from.joint_angles[0], from.joint_angles[1] + 0.25));
    EXPECT_THAT(start.joint_velocities, ElementsAre(0, 0));
    speeds.insert(start.velocity[0]);
  }
  EXPECT_THAT(speeds, ElementsAre(0, 1));
}

// First as in the pose, half around x; then a quarter around the world's z.
TEST_F(StartTest, TurnsThePoseInTheWorld) {
  const auto task = MakeTask(1);
  for (int64_t episode = 1; episode <= 20; ++episode) {
    task->SetNextEpisode(episode);
    const robot::StartState start = task->DrawStart().value();
    const double half = std::sqrt(0.5);
    if (start.from.name == "second") {
      EXPECT_THAT(start.pose.orientation,
                  ElementsAre(DoubleNear(0, 1e-15), DoubleNear(half, 1e-15),
                              DoubleNear(half, 1e-15), DoubleNear(0, 1e-15)));
    } else {
      EXPECT_THAT(start.pose.orientation,
                  ElementsAre(DoubleNear(half, 1e-15), 0, 0, DoubleNear(half, 1e-15)));
    }
  }
}

TEST_F(StartTest, DependsOnTheSeedOfTheRunAndTheNumberOfTheEpisode) {
  const auto poses = [&](uint64_t seed, int64_t first) {
    const auto task = MakeTask(seed);
    std::string drawn;
    for (int64_t episode = first; episode < first + 30; ++episode) {
      task->SetNextEpisode(episode);
      drawn += task->DrawStart().value().from.name[0];
    }
    return drawn;
  };
  EXPECT_EQ(poses(1, 1), poses(1, 1));
  EXPECT_NE(poses(1, 1), poses(2, 1));
  EXPECT_NE(poses(1, 1), poses(1, 31));
}

TEST_F(StartTest, IsAnotherOneOfThePoseInEachAttempt) {
  const auto task = MakeTask(1);
  const robot::StartState first = task->DrawStart().value();
  for (const uint32_t attempt : {1u, 2u, 0u}) {
    robot::StartState start = task->DrawStart(attempt).value();
    EXPECT_EQ(start.velocity[1], attempt);
    start.velocity[1] = 0;
    EXPECT_EQ(start, first);
  }
}

TEST_F(StartTest, FollowsTheParams) {
  const auto task = MakeTask(1);
  task->Set("bend", -0.5);
  const robot::StartState start = task->DrawStart().value();
  EXPECT_EQ(start.pose.joint_angles[1], start.from.joint_angles[1] - 0.5);
}

TEST_F(StartTest, OfATaskWithoutAPoseIsNone) {
  UniversalTask task("task", robot_, std::make_unique<TaskInstance>(LoadTask("told")), 1);
  EXPECT_FALSE(task.DrawStart());
}

TEST_F(StartTest, BeyondAStopIsRefused) {
  const auto task = MakeTask(1);
  task->Set("bend", 5.0);
  EXPECT_THAT(MessageOf([&] { task->DrawStart(); }),
              HasSubstr("rad, and its stops are at -1 and 2 rad: build the task again for this "
                        "robot with `taskc build`"));
}

TEST_F(StartTest, InAPoseThatTheRobotDoesNotHaveIsRefused) {
  robot_.poses.pop_back();
  EXPECT_THAT(MessageOf([&] { MakeTask(1); }),
              HasSubstr("the task starts in the pose `second`, which the robot `walker` does not "
                        "have"));
}

}  // namespace
}  // namespace runtime
