#include <gmock/gmock.h>

#include <cstdlib>

#include "plugins/robot/robot_description.h"
#include "tests/scoped_environment.h"

namespace robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string MessageFor(const std::string& name, const std::vector<std::filesystem::path>& folders) {
  try {
    FindRobotFile(name, folders);
  } catch (const DescriptionError& error) {
    return error.what();
  }
  return "found";
}

TEST(FindRobot, TakesTheFirstFolderThatHasIt) {
  EXPECT_EQ(FindRobotFile("hopper", {"/nowhere", ROBOTS, STAGED_ROBOTS}),
            ROBOTS "/hopper/robot.toml");
  EXPECT_EQ(FindRobotFile("humanoid", {ROBOTS, STAGED_ROBOTS}),
            STAGED_ROBOTS "/humanoid/robot.toml");
}

TEST(FindRobot, SuggestsTheNearestName) {
  EXPECT_EQ(MessageFor("hoper", {ROBOTS, STAGED_ROBOTS}),
            "there is no robot `hoper`\n  help: did you mean `hopper`? (looked in " ROBOTS
            " " STAGED_ROBOTS "; `--robots DIR` or TASKC_ROBOT_PATH look elsewhere)");
}

TEST(FindRobot, ListsTheRobotsIfNoneIsNear) {
  EXPECT_THAT(MessageFor("submarine", {ROBOTS}),
              HasSubstr("choose from `blocks`, `hopper` and `tinker`"));
}

TEST(FindRobot, SaysWhereItLookedIfThereIsNoRobotAtAll) {
  EXPECT_EQ(MessageFor("hopper", {"/nowhere"}),
            "there is no robot `hopper`\n  help: there is none at all (looked in /nowhere; "
            "`--robots DIR` or TASKC_ROBOT_PATH look elsewhere)");
}

TEST(FindRobot, TheEnvironmentComesBeforeTheProgramsOwnFolder) {
  const ScopedEnvironment robots("TASKC_ROBOT_PATH", "/a:/b/c:");
  const auto folders = DefaultRobotFolders();
  ASSERT_EQ(folders.size(), 3u);
  EXPECT_EQ(folders[0], "/a");
  EXPECT_EQ(folders[1], "/b/c");
  // Test programs lie beside bin/, so their share/ is that of the programs.
  EXPECT_EQ(folders[2], STAGED_ROBOTS);
}

TEST(FindRobot, AGivenFolderComesFirstThenThoseOfTheTasksFiles) {
  const ScopedEnvironment robots("TASKC_ROBOT_PATH", "/a");
  EXPECT_THAT(RobotFolders({"tasks/one.task", "base.task", "tasks/two.task"}, "mine"),
              ElementsAre("mine", "tasks", ".", "/a", STAGED_ROBOTS));
  EXPECT_THAT(RobotFolders({"one.task"}, ""), ElementsAre(".", "/a", STAGED_ROBOTS));
}

TEST(FindRobot, AFolderIsCalledAsItsRobot) {
  EXPECT_EQ(ReadRobotCalled("hopper", ROBOTS "/hopper/robot.toml").name, "hopper");
  try {
    ReadRobotCalled("jumper", ROBOTS "/hopper/robot.toml");
    FAIL() << "no error";
  } catch (const DescriptionError& error) {
    EXPECT_STREQ(error.what(), ROBOTS
                 "/hopper/robot.toml:3:8: error: the robot in the folder `jumper` is called "
                 "`hopper`\n  help: write `name = \"jumper\"`, or rename the folder");
  }
}

TEST(FindRobot, StagedHumanoidCanBeRead) {
  EXPECT_EQ(ReadRobot(FindRobotFile("humanoid", DefaultRobotFolders())).name, "humanoid");
}

}  // namespace
}  // namespace robot
