#include "runtime/core/task/robot_check.h"

#include <gtest/gtest.h>

#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

std::string MessageOfCheck(const std::string& plugin) {
  return MessageOf([&] { CheckFitsRobot(Plugin(PluginFile(plugin)), Walker()); });
}

TEST(CheckFitsRobot, AcceptsWhatFits) {
  EXPECT_EQ(MessageOfCheck("walking"), "no error");
  EXPECT_EQ(MessageOfCheck("empty"), "no error");
}

TEST(CheckFitsRobot, AcceptsATaskForAnyRobotThatKnowsTheNumberOfLinks) {
  EXPECT_EQ(MessageOfCheck("for_any_robot"), "no error");
}

TEST(CheckFitsRobot, RefusesATaskForAnotherRobot) {
  EXPECT_EQ(MessageOfCheck("other_robot"),
            "test.task: the task `test` is for the robot `snake`, and this run has the robot "
            "`walker`");
}

TEST(CheckFitsRobot, RefusesATaskForOtherJointsOrInAnotherOrder) {
  EXPECT_EQ(MessageOfCheck("other_order"),
            "test.task: the task was built for another `walker`, with other joints or in another "
            "order; build it again with `taskc build`");
}

TEST(CheckFitsRobot, RefusesATaskForOtherSites) {
  EXPECT_EQ(MessageOfCheck("other_sites"),
            "test.task: the task was built for another `walker`, with other sites or in another "
            "order; build it again with `taskc build`");
}

// Another module may offer it: that is found out where there are modules.
TEST(CheckFitsRobot, AcceptsASensorThatNoRobotHas) {
  EXPECT_EQ(MessageOfCheck("own_sensor"), "no error");
}

TEST(CheckFitsRobot, RefusesASensorWithAnotherNumberOfElementsThanItsType) {
  EXPECT_EQ(MessageOfCheck("own_sensor_of_other_size"),
            "test.task: the task was built for another `walker`: its sensor `ball.position` has 5 "
            "elements, which no `vec3` has; build it again with `taskc build`");
}

TEST(CheckFitsRobot, RefusesAnotherType) {
  EXPECT_EQ(
      MessageOfCheck("sensor_of_other_type"),
      "test.task: the task reads the sensor `base.velocity` as `quat [m/s]`, and "
      "the robot `walker` gives `vec3 [m/s]`: correct the task, and build it again with `taskc "
      "build`");
}

TEST(CheckFitsRobot, RefusesAnotherUnit) {
  EXPECT_EQ(MessageOfCheck("sensor_of_other_unit"),
            "test.task: the task reads the sensor `base.velocity` as `vec3 [m]`, and the "
            "robot `walker` gives `vec3 [m/s]`: correct the task, and build it again with `taskc "
            "build`");
}

TEST(CheckFitsRobot, RefusesABodyWithAnotherNumberOfLinks) {
  EXPECT_EQ(MessageOfCheck("other_body"),
            "test.task: the task was built for another `walker`: its sensor `contact` has 18 "
            "elements, this robot's has 3; build it again with `taskc build`");
}

}  // namespace
}  // namespace runtime
