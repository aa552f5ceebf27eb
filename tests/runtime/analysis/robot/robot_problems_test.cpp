#include "runtime/analysis/robot/robot_problems.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "runtime/analysis/robot/robot_report.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<RobotProblem> ProblemsOfBody(const robot::RobotDescription& robot) {
  return ProblemsOf(robot, PropertiesOf(robot));
}

TEST(RobotProblems, RobotsThatAreShippedHaveNone) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(PLUGINS)) {
    if (!std::filesystem::exists(entry.path() / "robot.toml")) continue;
    const robot::RobotDescription robot = robot::ReadRobot(entry.path() / "robot.toml");
    EXPECT_THAT(ToText(RobotReport(robot, FindProfile("fast-tree"))), Not(HasSubstr("warning")));
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(RobotProblems, SaysByHowMuchToRaiseARobotThatIsInTheGround) {
  robot::RobotDescription robot = Humanoid();
  robot::Pose pose = *robot.FindPose("standing");
  pose.position[2] -= 0.02;
  const auto problems = ProblemsOf(robot, HoldPose(robot, FindProfile("fast-tree"), pose, 0.005));
  ASSERT_FALSE(problems.empty());
  EXPECT_THAT(problems[0].text, HasSubstr("mm in the ground in pose `standing`"));
  EXPECT_THAT(problems[0].help, HasSubstr("its z may be more by 0.02"));
}

TEST(RobotProblems, NamesLinksThatAreWithinEachOther) {
  robot::RobotDescription robot = Tinker();
  robot.links[5].position = {0.08, 0, -0.05};  // the tail in the wheel
  robot.mounts[1].anchor = {0.08, 0, -0.05};
  const auto problems = ProblemsOf(
      robot, HoldPose(robot, FindProfile("fast-tree"), *robot.FindPose("turned"), 0.005));
  ASSERT_FALSE(problems.empty());
  EXPECT_THAT(problems[0].text, HasSubstr("`wheel` and `tail` are within each other by"));
  EXPECT_THAT(problems[0].help, HasSubstr("contact_exclusions = [[\"wheel\", \"tail\"]]"));
}

TEST(RobotProblems, SaysThatAJointShakes) {
  const robot::RobotDescription robot = Rotor();
  HeldPose held;
  held.pose = "turned";
  held.profile = "paper";
  held.size = 0.2;
  held.chatter = 9.3;
  held.chattering_joint = 0;
  const auto problems = ProblemsOf(robot, held);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text,
            "`axle` shakes with 9.3 rad/s while it holds pose `turned` in profile `paper`");
  EXPECT_THAT(problems[0].help, HasSubstr("take profile `fast`"));
}

TEST(RobotProblems, SaysThatNoMotorIsSoStrong) {
  robot::RobotDescription robot = Humanoid();
  robot.joints[0].gains.max_torque = 1000;
  const auto problems = ProblemsOfBody(robot);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_THAT(problems[0].text,
              HasSubstr("the motors of `" + robot.joints[0].name + "` could hold up "));
  EXPECT_THAT(problems[0].help, HasSubstr("check the unit of `max_torque`, N m"));
  robot.joints[0].passive.armature = 1;  // a rotor that such a motor has to turn as well
  EXPECT_THAT(ProblemsOfBody(robot), IsEmpty());
}

TEST(RobotProblems, KnowsWhichInertiasNoBodyHas) {
  robot::RobotDescription robot = Rotor();
  robot.links[0].inertia = robot::Inertia{4, 4, 4, 0, 0, 0};  // kg cm^2, for example
  EXPECT_THAT(ProblemsOfBody(robot)[0].text, HasSubstr("the inertia of `hub`, 4 kg m^2, is more"));
  robot.links[0].inertia = robot::Inertia{1e-9, 1e-9, 1e-9, 0, 0, 0};
  EXPECT_THAT(ProblemsOfBody(robot)[0].text, HasSubstr("as if its 1 kg were a point"));
  robot.links[0].inertia = robot::Inertia{0.004, 0.004, 0.004, 0, 0, 0};
  EXPECT_THAT(ProblemsOfBody(robot), IsEmpty());
  robot.links[1].mass = 1000;
  EXPECT_THAT(ProblemsOfBody(robot)[0].text, HasSubstr("`wheel` has a density of"));
}

}  // namespace
}  // namespace runtime
