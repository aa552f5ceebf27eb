#include "runtime/training/simulation/soundness.h"

#include <gmock/gmock.h>

#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::Property;

class SoundnessTest : public testing::TestWithParam<const char*> {
 protected:
  // In the air, where nothing but a push changes the energy.
  World Make() const {
    robot::Pose pose = Humanoid().poses[0];
    pose.position[2] = 10;
    return World(Humanoid(), FindProfile(GetParam()), pose);
  }
  // Gives all links a speed upward [m/s], which adds speed^2 / 2 for each kg.
  static void Push(const World& world, double speed) {
    for (int i = 0; i < world.body().link_count(); ++i) {
      dBodySetLinearVel(world.body().body(i), 0, 0, speed);
      dBodySetAngularVel(world.body().body(i), 0, 0, 0);
    }
  }
  // So that the bound on the motors' work is 0.
  static std::vector<double> Still() { return Zeros(Humanoid()); }
};

INSTANTIATE_TEST_SUITE_P(, SoundnessTest, testing::ValuesIn(BuiltProfiles()), ProfileInName);

// A lift of 5 cm takes 0.49 J for each kg: a push to 0.9 m/s gives less, one to 1.1 m/s more.
TEST_P(SoundnessTest, EnergyFromNothingIsAFailureFromALiftOfFiveCentimetersOn) {
  World world = Make();
  world.Step(Still());
  Push(world, 0.9);
  EXPECT_NO_THROW(world.Step(Still()));
  World other = Make();
  other.Step(Still());
  Push(other, 1.1);
  EXPECT_THAT([&] { other.Step(Still()); },
              testing::Throws<OdeFailure>(
                  Property(&OdeFailure::what, HasSubstr("energy appears from nothing"))));
}

TEST_P(SoundnessTest, EnergyFromNothingAddsUp) {
  World world = Make();
  world.Step(Still());
  Push(world, 0.8);  // 0.32 J for each kg
  EXPECT_NO_THROW(world.Step(Still()));
  Push(world, 0);
  EXPECT_NO_THROW(world.Step(Still()));
  Push(world, 0.8);
  EXPECT_THROW(world.Step(Still()), OdeFailure);
}

TEST_P(SoundnessTest, WhatTheMotorsGiveIsNotFromNothing) {
  World world = Make();
  std::vector<double> targets = Zeros(Humanoid());
  for (int swing = 0; swing < 10; ++swing) {
    for (size_t j = 0; j < targets.size(); ++j) targets[j] = swing % 2 == 0 ? 0.5 : -0.1;
    EXPECT_NO_THROW(StepFor(world, 0.1, targets)) << swing;
  }
}

TEST_P(SoundnessTest, AJointFarBeyondItsStopIsAFailure) {
  robot::Pose pose = Humanoid().poses[0];
  const robot::Joint& neck = Humanoid().joints[0];
  pose.position[2] = 10;
  pose.joint_angles[0] = neck.high + 0.45;
  World near(Humanoid(), FindProfile(GetParam()), pose);
  EXPECT_NO_THROW(near.Step(Still()));
  pose.joint_angles[0] = neck.high + 0.55;
  World far(Humanoid(), FindProfile(GetParam()), pose);
  EXPECT_THAT([&] { far.Step(Still()); },
              testing::Throws<OdeFailure>(
                  Property(&OdeFailure::what, HasSubstr("neck_yaw is far beyond its stop"))));
}

}  // namespace
}  // namespace runtime
