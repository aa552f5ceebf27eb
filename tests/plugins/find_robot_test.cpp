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
            " " STAGED_ROBOTS "; set TASKC_ROBOT_PATH to look elsewhere)");
}

TEST(FindRobot, ListsTheRobotsIfNoneIsNear) {
  EXPECT_THAT(MessageFor("quadruped", {ROBOTS, STAGED_ROBOTS}),
              HasSubstr("choose from `hopper` and `humanoid`"));
}

TEST(FindRobot, SaysWhereItLookedIfThereIsNoRobotAtAll) {
  EXPECT_EQ(MessageFor("hopper", {"/nowhere"}),
            "there is no robot `hopper`\n  help: there is none at all (looked in /nowhere; set "
            "TASKC_ROBOT_PATH to look elsewhere)");
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

TEST(FindRobot, StagedHumanoidCanBeRead) {
  EXPECT_EQ(ReadRobot(FindRobotFile("humanoid", DefaultRobotFolders())).name, "humanoid");
}

}  // namespace
}  // namespace robot
