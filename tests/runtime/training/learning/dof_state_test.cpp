#include "runtime/training/learning/dof_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "tests/runtime/training/learning/fake_sensors.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::HasSubstr;

// Joint j has the angle j and the rate 100 + j; the base's quantities are 31, 32, ...
FakeSensors CountingSensors() {
  FakeSensors sensors;
  std::iota(sensors.joint_angle.begin(), sensors.joint_angle.end(), 0);
  std::iota(sensors.joint_velocity.begin(), sensors.joint_velocity.end(), 100);
  sensors.base_position = {31, 32, 33};
  sensors.base_orientation = {41, 42, 43, 44};
  sensors.base_velocity = {51, 52, 53};
  sensors.base_angular_velocity = {61, 62, 63};
  return sensors;
}

std::vector<double> StateFor(const std::string& dof) {
  FakeSensors sensors = CountingSensors();
  FakeSensorModule environment(&sensors);
  DofState state("state", HumanoidContext());
  state.Set("dof", dof);
  environment.ConnectTo(state);
  state.Start();
  const Eigen::VectorXd& values = state.Read();
  return {values.begin(), values.end()};
}

TEST(DofState, HoldsBaseAnglesVelocitiesRatesInThisOrder) {
  EXPECT_THAT(StateFor("5"), testing::ElementsAre(33, 41, 42, 43, 44,      //
                                                  1, 3, 8, 9, 10,          //
                                                  51, 52, 53, 61, 62, 63,  //
                                                  101, 103, 108, 109, 110));
  EXPECT_THAT(StateFor("4asym"), testing::ElementsAre(33, 41, 42, 43, 44,      //
                                                      1, 4, 10, 15,            //
                                                      51, 52, 53, 61, 62, 63,  //
                                                      101, 104, 110, 115));
}

TEST(DofState, HasThePublishedSizes) {
  EXPECT_EQ(State::Size(3), 17);
  EXPECT_EQ(State::Size(4), 19);
  EXPECT_EQ(State::Size(5), 21);
  EXPECT_EQ(State::Size(7), 25);
}

TEST(DofState, ReadsTheSensorsAsTheyAreNow) {
  FakeSensors sensors;
  FakeSensorModule environment(&sensors);
  DofState state("state", HumanoidContext());
  environment.ConnectTo(state);
  state.Start();
  EXPECT_EQ(state.Read()[0], 0);
  sensors.base_position[2] = 0.25;
  EXPECT_EQ(state.Read()[0], 0.25);
}

TEST(DofState, UnknownDofNamesTheNearest) {
  DofState state("state", HumanoidContext());
  state.Set("dof", "4asim");
  EXPECT_THAT(UserErrorOf([&] { state.dof(); }),
              testing::AllOf(HasSubstr("state.dof"), HasSubstr("humanoid"), HasSubstr("4asym")));
}

TEST(DofState, NeedsAllSensors) {
  DofState state("state", HumanoidContext());
  EXPECT_THAT(UserErrorOf([&] { state.Start(); }),
              testing::AllOf(HasSubstr("state.base.position"), HasSubstr("vec3 [m]")));
}

}  // namespace
}  // namespace runtime
