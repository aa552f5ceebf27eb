#include "runtime/training/learning/motion_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/runtime/training/learning/fake_sensors.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/time_step.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::HasSubstr;

constexpr int kNeckYaw = 0, kLeftHipRoll = 7, kLeftHipPitch = 8, kLeftKneePitch = 9;
constexpr int kRightHipRoll = 12, kRightHipPitch = 13;

// Environment and learner of an action space, and hears of the ends of its actions.
class Stage : public FakeSensorModule {
 public:
  explicit Stage(MotionPlayer& player) : FakeSensorModule(&sensors) {
    Port::Connect(FindPort("joint.angle"), player.FindPort("joint.angle"));
    for (const char* port :
         {"start_of_episode", "start_of_time_step", "end_of_time_step", "execute", "joint_targets",
          "standstill", "frequency", "end_of_action"}) {
      Port::Connect(FindPort(port), player.FindPort(port));
    }
  }

  void RunTimeStep() {
    start_of_time_step(kTimeStep);
    end_of_time_step(kTimeStep);
  }

  FakeSensors sensors;
  int ended = 0;
  Signal<> start_of_episode{this, "start_of_episode"};
  Signal<double> start_of_time_step{this, "start_of_time_step"};
  Signal<double> end_of_time_step{this, "end_of_time_step"};
  Signal<const Eigen::VectorXd&> execute{this, "execute"};
  In<Eigen::VectorXd> joint_targets{this, "joint_targets"};
  In<Eigen::VectorXd> standstill{this, "standstill"};
  In<double> frequency{this, "frequency"};

 private:
  void EndOfAction() { ++ended; }
  Slot<> end_of_action_{this, "end_of_action", Bind<&Stage::EndOfAction>{}};
};

class MotionPlayerTest : public testing::Test {
 protected:
  MotionPlayerTest() {
    player_.Set("action_steps", int64_t{4});
    player_.Set("harmonics", int64_t{1});
    player_.Set("lowest_frequency", 2);
    player_.Set("highest_frequency", 2);
    stage_.sensors.joint_angle[kNeckYaw] = 0.25;
    stage_.sensors.joint_angle[kLeftHipPitch] = 0.5;
    stage_.sensors.joint_angle[kRightHipPitch] = 0.5;
  }
  void Start() {
    player_.Start();
    stage_.start_of_episode();
  }

  MotionPlayer player_{"player", HumanoidContext()};
  Stage stage_{player_};
};

TEST_F(MotionPlayerTest, StandsStillInThePoseThatTheEpisodeStartsIn) {
  Start();
  ASSERT_EQ(stage_.standstill().size(), 1 + 5 * 3);
  stage_.execute(stage_.standstill());
  for (int i = 0; i < 20; ++i) stage_.RunTimeStep();
  for (int joint = 0; joint < 17; ++joint) {
    EXPECT_NEAR(stage_.joint_targets()[joint],
                stage_.sensors.joint_angle[static_cast<size_t>(joint)], 1e-14)
        << joint;
  }
}

// Hips range from -90 to 90 degrees, and left and right move alike.
TEST_F(MotionPlayerTest, MovesTheCoordinatesAroundThatPose) {
  player_.Set("action_steps", int64_t{12});
  Start();
  Eigen::VectorXd motion = stage_.standstill();
  motion[1 + 2 * 3 + 1] = 0.2;  // sine of the hips
  stage_.execute(motion);
  EXPECT_EQ(stage_.frequency(), 2);
  for (int step = 0; step < 12; ++step) {
    stage_.start_of_time_step(kTimeStep);
    const double angle = 4 * std::numbers::pi * kTimeStep * step;
    const double expected = 0.5 + 0.2 * std::numbers::pi / 2 * std::sin(angle);
    EXPECT_NEAR(stage_.joint_targets()[kLeftHipPitch], expected, 1e-14);
    EXPECT_NEAR(stage_.joint_targets()[kRightHipPitch], expected, 1e-14);
    EXPECT_NEAR(stage_.joint_targets()[kNeckYaw], 0.25, 1e-14);
    stage_.end_of_time_step(kTimeStep);
  }
}

// One side has eight joints; hips roll from -90 to 20 degrees.
TEST_F(MotionPlayerTest, SidesAlternate) {
  player_.Set("dof", std::string("all"));
  player_.Set("symmetry", std::string("alternating"));
  player_.Set("action_steps", int64_t{100});
  Start();
  ASSERT_EQ(stage_.standstill().size(), 1 + 8 * 3);
  Eigen::VectorXd motion = stage_.standstill();
  motion[1 + 3 * 3 + 1] = 0.2;  // sine of the left hip's roll
  motion[1 + 4 * 3 + 2] = 0.1;  // cosine of its pitch
  stage_.execute(motion);
  for (int step = 0; step < 100; ++step) {
    stage_.start_of_time_step(kTimeStep);
    const double angle = 4 * std::numbers::pi * kTimeStep * step;
    const double roll = 0.2 * 55 * std::numbers::pi / 180 * std::sin(angle);
    const double pitch = 0.1 * std::numbers::pi / 2 * std::cos(angle);
    EXPECT_NEAR(stage_.joint_targets()[kLeftHipRoll], roll, 1e-12);
    EXPECT_NEAR(stage_.joint_targets()[kRightHipRoll], roll, 1e-12);  // -1 and half a period
    EXPECT_NEAR(stage_.joint_targets()[kLeftHipPitch], 0.5 + pitch, 1e-12);
    EXPECT_NEAR(stage_.joint_targets()[kRightHipPitch], 0.5 - pitch, 1e-12);
    EXPECT_NEAR(stage_.joint_targets()[kNeckYaw], 0.25, 1e-14);
    stage_.end_of_time_step(kTimeStep);
  }
}

TEST_F(MotionPlayerTest, AGroupOfJointsMovesEachByItself) {
  player_.Set("dof", std::string("left_leg"));
  player_.Set("symmetry", std::string("alternating"));
  Start();
  EXPECT_EQ(stage_.standstill().size(), 1 + 5 * 3);
  player_.Set("dof", std::string("left_legs"));
  EXPECT_THAT(UserErrorOf([&] { player_.Start(); }), HasSubstr("did you mean `left_leg`?"));
}

TEST_F(MotionPlayerTest, SidesMirrorEachOther) {
  player_.Set("dof", std::string("all"));
  player_.Set("symmetry", std::string("mirrored"));
  Start();
  ASSERT_EQ(stage_.standstill().size(), 1 + 8 * 3);
  Eigen::VectorXd motion = stage_.standstill();
  motion[1 + 3 * 3 + 2] = 0.1;  // cosine of the left hip's roll
  motion[1 + 4 * 3 + 2] = 0.1;  // and of its pitch
  stage_.execute(motion);
  stage_.start_of_time_step(kTimeStep);
  const double roll = 0.1 * 55 * std::numbers::pi / 180;
  EXPECT_NEAR(stage_.joint_targets()[kLeftHipRoll], roll, 1e-12);
  EXPECT_NEAR(stage_.joint_targets()[kRightHipRoll], -roll, 1e-12);
  EXPECT_NEAR(stage_.joint_targets()[kLeftHipPitch], 0.5 + 0.05 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(stage_.joint_targets()[kRightHipPitch], 0.5 + 0.05 * std::numbers::pi, 1e-12);
}

TEST_F(MotionPlayerTest, AMotionThatIsDoneOnceDoesNotAlternate) {
  player_.Set("symmetry", std::string("alternating"));
  player_.Set("dof", std::string("all"));
  player_.Set("kind", std::string("one_shot"));
  EXPECT_THAT(UserErrorOf([&] { player_.Start(); }),
              HasSubstr("`player.symmetry` is `alternating`, but a motion that is done once "
                        "(`player.kind`) has no half a period"));
}

TEST_F(MotionPlayerTest, AMotionGoesOnFromActionToAction) {
  Start();
  Eigen::VectorXd motion = stage_.standstill();
  motion[2] = 0.3;
  stage_.execute(motion);
  for (int step = 0; step < 10; ++step) {
    const int ended = stage_.ended;
    stage_.RunTimeStep();
    if (stage_.ended == ended) continue;
    EXPECT_EQ(step % 4, 3);
    stage_.execute(motion);
  }
  EXPECT_EQ(stage_.ended, 2);
  const Eigen::VectorXd targets = stage_.joint_targets();
  // The same without the ends of actions.
  player_.Set("action_steps", int64_t{100});
  stage_.start_of_episode();
  stage_.execute(motion);
  for (int step = 0; step < 10; ++step) stage_.RunTimeStep();
  EXPECT_EQ(stage_.joint_targets(), targets);
}

TEST_F(MotionPlayerTest, TargetsStayWithinTheStops) {
  player_.Set("dof", std::string("all"));
  Start();
  ASSERT_EQ(stage_.standstill().size(), 1 + 17 * 3);
  stage_.execute(Eigen::VectorXd::Ones(1 + 17 * 3));
  for (int step = 0; step < 50; ++step) {
    stage_.RunTimeStep();
    for (int joint = 0; joint < 17; ++joint) {
      const robot::Joint& stops = Humanoid().joints[static_cast<size_t>(joint)];
      EXPECT_LE(stage_.joint_targets()[joint], stops.high);
      EXPECT_GE(stage_.joint_targets()[joint], stops.low);
    }
  }
  EXPECT_EQ(stage_.joint_targets()[kLeftKneePitch],
            Humanoid().joints[kLeftKneePitch].high);  // it wants to go further
}

TEST_F(MotionPlayerTest, ParametersAreChecked) {
  player_.Set("lowest_frequency", 3);
  EXPECT_THAT(UserErrorOf([&] { player_.Start(); }),
              HasSubstr("`player.lowest_frequency` is 3 Hz, more than"));
  player_.Set("lowest_frequency", 1);
  player_.Set("dof", std::string("55"));
  EXPECT_THAT(UserErrorOf([&] { player_.Start(); }),
              HasSubstr("`player.dof`: the robot `humanoid` has no DoF configuration `55`"));
  player_.Set("dof", std::string("4asym"));
  player_.Start();
  stage_.start_of_episode();
  EXPECT_THAT(UserErrorOf([&] { stage_.execute(Eigen::VectorXd::Zero(3)); }),
              HasSubstr("an action of 3 numbers, and its motions have 13"));
}

}  // namespace
}  // namespace runtime
