#include "runtime/training/learning/dcob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/training/learning/bubble_net.h"
#include "runtime/training/learning/ng_net.h"
#include "runtime/training/learning/random.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/time_step.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::HasSubstr;

// Gives orders to a Dcob, and hears of the ends of its actions.
class Commander : public Module {
 public:
  Commander() : Module("commander") {}

  Signal<int> execute{this, "execute"};
  Signal<double> start_of_time_step{this, "start_of_time_step"};
  Signal<double> end_of_time_step{this, "end_of_time_step"};
  In<Eigen::VectorXd> joint_targets{this, "joint_targets"};
  In<int> action_count{this, "action_count"};
  int ended = 0;

 private:
  void EndOfAction() { ++ended; }
  Slot<> end_of_action_{this, "end_of_action", Bind<&Commander::EndOfAction>{}};
};

class DcobTest : public testing::Test {
 protected:
  void Use(const std::string& dof, const std::string& net) {
    state_ = std::make_unique<FakeState>(dof);
    features_.Set("net", net);
    Connect(*state_, "state", features_, "state");
    Connect(*state_, "state", dcob_, "state");
    Connect(features_, "features", dcob_, "features");
    Connect(features_, "net", dcob_, "net");
    for (const char* port : {"execute", "start_of_time_step", "end_of_time_step"}) {
      Connect(commander_, port, dcob_, port);
    }
    for (const char* port : {"end_of_action", "joint_targets", "action_count"}) {
      Connect(dcob_, port, commander_, port);
    }
  }
  void UseTurningAgent() {
    features_.Set("max_norm", true);
    dcob_.Set("max_norm", true);
    dcob_.Set("abbreviation_scale", 0.5);
    Use("4asym", "4asym_g4");
    features_.Start();
    dcob_.Start();
  }

  // The time steps until the action is over.
  int Execute(int action) {
    const int ended_before = commander_.ended;
    commander_.execute(action);
    int steps = 0;
    while (commander_.ended == ended_before) {
      Step();
      ++steps;
    }
    return steps;
  }
  void Step() {
    commander_.start_of_time_step(kTimeStep);
    commander_.end_of_time_step(kTimeStep);
  }

  std::unique_ptr<FakeState> state_;
  NgNet features_{"features", HumanoidContext()};
  Dcob dcob_{"action_space", HumanoidContext()};
  Commander commander_;
};

TEST_F(DcobTest, HasAnActionForEachIntervalAndUnit) {
  Use("4asym", "4asym_g4");
  EXPECT_EQ(commander_.action_count(), 768);  // before the start, too
  dcob_.Start();
  EXPECT_EQ(commander_.action_count(), 768);
}

// Every d_k is 1.57, so T_N = 0.5 * 1.57 * g wherever the target is farther away than that:
// 58.9, 78.5 and 157 ms.
TEST_F(DcobTest, TurningTakes11Or15Or31TimeSteps) {
  UseTurningAgent();
  Random random(1);
  for (int unit = 0; unit < 256; ++unit) {
    // From a place near the unit at the opposite end of the grid.
    const int opposite = 255 - unit;
    for (int i = 0, digit = 1; i < 4; ++i, digit *= 4) {
      const double low = i < 2 ? -1.57 : -3.14, spacing = (3.14 - low) / 3;
      state_->angles()[i] = low + opposite / digit % 4 * spacing + 0.1 * random.Uniform();
    }
    ASSERT_EQ(Execute(3 * unit), 11);
    ASSERT_EQ(Execute(3 * unit + 1), 15);
    ASSERT_EQ(Execute(3 * unit + 2), 31);
  }
}

// Measured for the original's net, from the centers of random units to those of others: 18.6, 25.0
// and 50.4 time steps on average, 13 to 67.
TEST_F(DcobTest, MotionsOverBq01LastAsLongAsMeasured) {
  Use("5", "bq01");
  features_.Start();
  dcob_.Start();
  const GaussianNet net = BubbleNet(PackSpheres(HumanoidNet("bq01"), 1), Norm::kEuclidean);
  Random random(1);
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  constexpr int kMotions = 500;
  for (int motion = 0; motion < kMotions; ++motion) {
    const auto from = static_cast<int>(300 * random.Uniform());
    const int to = (from + 1 + static_cast<int>(299 * random.Uniform())) % 300;
    state_->angles() = net.centers().row(from);
    for (int interval = 0; interval < 3; ++interval) {
      const int steps = Execute(3 * to + interval);
      ASSERT_GE(steps, 12);
      ASSERT_LE(steps, 69);
      sums[interval] += steps;
    }
  }
  EXPECT_NEAR(sums[0] / kMotions, 18.6, 0.4);
  EXPECT_NEAR(sums[1] / kMotions, 25.0, 0.5);
  EXPECT_NEAR(sums[2] / kMotions, 50.4, 1.0);
}

// Unit 1 differs from unit 0 in the first coordinate only, whose spacing is 1.57 = d_k: not farther
// away, so the whole T = 1.57 * 0.075 = 0.11775 s.
TEST_F(DcobTest, NeighborsAreReachedInFullTime) {
  UseTurningAgent();
  state_->angles() << -1.57 + 1e-6, -1.57, -3.14, -3.14;
  EXPECT_EQ(Execute(3), 23);
}

TEST_F(DcobTest, CommandsJointTargetsAlongTheMotion) {
  UseTurningAgent();
  EXPECT_TRUE(commander_.joint_targets().isZero(0));
  ASSERT_EQ(commander_.joint_targets().size(), 17);
  state_->angles() << 0.1, 0.2, 0.3, 0.4;
  commander_.execute(0);  // to (-1.57, -1.57, -3.14, -3.14)
  commander_.start_of_time_step(kTimeStep);
  Eigen::VectorXd expected(17);
  expected << 0, 0.1, 0, 0.1, 0.2, 0, 0.2, 0, 0.3, -0.3, 0.3, 0, 0, 0.4, -0.4, 0.4, 0;
  EXPECT_EQ(commander_.joint_targets(), expected);
  commander_.end_of_time_step(kTimeStep);

  // T = 0.075 * 3.54 = 0.2655 s; (1 - 0.005 / 0.2655)^3 = 0.9445605; 0.4 - 3.54 * 0.0554395.
  commander_.start_of_time_step(kTimeStep);
  EXPECT_NEAR(commander_.joint_targets()[13], 0.20374283441, 1e-11);
}

TEST_F(DcobTest, HoldsTheLastCommandBetweenActions) {
  UseTurningAgent();
  Execute(0);
  const Eigen::VectorXd last = commander_.joint_targets();
  EXPECT_EQ(commander_.ended, 1);
  Step();
  EXPECT_EQ(commander_.joint_targets(), last);
  EXPECT_EQ(commander_.ended, 1);
}

TEST_F(DcobTest, AnActionReplacesTheOneThatRuns) {
  UseTurningAgent();
  state_->angles() << 3.1, 3.1, 3.1, 3.1;
  commander_.execute(0);
  for (int i = 0; i < 5; ++i) Step();
  EXPECT_EQ(Execute(1), 15);
}

// z = 0.24 and qw = 1 make the distance over the whole state longer: from the middle between two
// neighbors, 0.785 over the angles and sqrt(0.785^2 + 0.24^2 + 1 + 25 * 4) over all, with the four
// rates at 5 rad/s. T = 0.075 * 0.785 = 0.058875 s, abbreviated to 1.57 / 10.08 of it: 9.2 ms.
TEST_F(DcobTest, TargetStateMeasuresTheWholeState) {
  dcob_.Set("target", "state");
  Use("4asym", "4asym_g4");
  dcob_.Start();
  state_->values[State::kHeight] = 0.24;
  state_->values[State::kOrientation] = 1;
  state_->angles() << -0.785, -1.57, -3.14, -3.14;
  state_->values.tail(4).setConstant(5);
  EXPECT_EQ(Execute(0), 1);
}

TEST_F(DcobTest, TargetAnglesMeasuresTheAnglesOnly) {
  Use("4asym", "4asym_g4");
  dcob_.Start();
  state_->values[State::kHeight] = 0.24;
  state_->values[State::kOrientation] = 1;
  state_->angles() << -0.785, -1.57, -3.14, -3.14;
  state_->values.tail(4).setConstant(5);
  EXPECT_EQ(Execute(0), 11);  // 0.785 < 1.57: the full 58.875 ms
}

TEST_F(DcobTest, IntervalsMustBePositive) {
  Use("4asym", "4asym_g4");
  EXPECT_THAT(UserErrorOf([this] {
                dcob_.Set("intervals", std::vector<double>{0.1, -0.2});
              }),
              HasSubstr("action_space.intervals"));
  dcob_.Set("intervals", std::vector<double>{0.1, 0});
  EXPECT_THAT(UserErrorOf([this] { dcob_.Start(); }), HasSubstr("greater than 0"));
  dcob_.Set("intervals", std::vector<double>{});
  EXPECT_THAT(UserErrorOf([this] { dcob_.Start(); }), HasSubstr("empty"));
}

TEST_F(DcobTest, TargetIsOneOfTwo) {
  EXPECT_THAT(UserErrorOf([this] { dcob_.Set("target", "angle"); }), HasSubstr("`angles`"));
}

TEST_F(DcobTest, FeaturesAndNetMustBelongTogether) {
  NgNet other("other", HumanoidContext());
  other.Set("net", std::string("4asym_g5"));
  Use("4asym", "4asym_g4");
  Connect(*state_, "state", other, "state");
  Port::Disconnect(features_.FindPort("features"), dcob_.FindPort("features"));
  Connect(other, "features", dcob_, "features");
  other.Start();
  dcob_.Start();
  EXPECT_THAT(UserErrorOf([this] { commander_.execute(0); }),
              testing::AllOf(HasSubstr("625 features"), HasSubstr("256 units")));
}

TEST_F(DcobTest, NeedsItsInputs) {
  EXPECT_THAT(UserErrorOf([this] { dcob_.Start(); }), HasSubstr("action_space.state"));
}

TEST_F(DcobTest, AnActionThatItHasNotIsRefused) {
  UseTurningAgent();
  const int count = commander_.action_count();
  for (const int action : {-1, count}) {
    EXPECT_EQ(UserErrorOf([&] { commander_.execute(action); }),
              "`action_space` gets action " + std::to_string(action) + " and has " +
                  std::to_string(count) + " actions: take their number from it");
  }
  EXPECT_GT(Execute(count - 1), 0);
}

}  // namespace
}  // namespace runtime
