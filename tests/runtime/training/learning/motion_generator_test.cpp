#include "runtime/training/learning/motion_generator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/training/learning/motion_player.h"
#include "tests/runtime/training/learning/fake_sensors.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using std::numbers::pi;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kGeneratorTimeStep = 0.005;

// Environment of a generator and of a player beside it, which does the same.
class GeneratorStage : public FakeSensorModule {
 public:
  GeneratorStage() : FakeSensorModule(&sensors) {
    sensors.joint_angle[0] = 0.25;
    for (Module* motion : {static_cast<Module*>(&generator), static_cast<Module*>(&player)}) {
      motion->Set("harmonics", int64_t{1});
      Port::Connect(FindPort("joint.angle"), motion->FindPort("joint.angle"));
      for (Port* port :
           {static_cast<Port*>(&start_of_episode), static_cast<Port*>(&start_of_time_step),
            static_cast<Port*>(&end_of_time_step)}) {
        Port::Connect(*port, motion->FindPort(port->name()));
      }
    }
    Port::Connect(generator.FindPort("joint_targets"), joint_targets);
    Port::Connect(generator.FindPort("phase"), phase);
    Port::Connect(player.FindPort("joint_targets"), player_targets);
    Port::Connect(execute, player.FindPort("execute"));
    player.Set("action_steps", int64_t{1'000'000});
  }

  FakeSensors sensors;
  Signal<> start_of_episode{this, "start_of_episode"};
  Signal<double> start_of_time_step{this, "start_of_time_step"};
  Signal<double> end_of_time_step{this, "end_of_time_step"};
  Signal<const Eigen::VectorXd&> execute{this, "execute"};
  In<Eigen::VectorXd> joint_targets{this, "joint_targets"};
  In<Eigen::VectorXd> phase{this, "phase"};
  In<Eigen::VectorXd> player_targets{this, "player_targets"};
  MotionGenerator generator{"motion", HumanoidContext()};
  MotionPlayer player{"player", HumanoidContext()};
};

TEST(MotionGenerator, DoesWhatAMotionPlayerDoesFromTheStartOfEachEpisode) {
  GeneratorStage stage;
  std::vector<double> parameters(1 + 5 * 3);
  for (size_t i = 0; i < parameters.size(); ++i) {
    parameters[i] = std::sin(static_cast<double>(i));
  }
  stage.generator.Set("parameters", parameters);
  stage.generator.Start();
  stage.player.Start();
  for (int episode = 0; episode < 2; ++episode) {
    stage.start_of_episode();
    stage.execute(Eigen::VectorXd::Map(parameters.data(), 16));
    for (int step = 0; step < 100; ++step) {
      stage.start_of_time_step(kGeneratorTimeStep);
      ASSERT_EQ(stage.joint_targets(), stage.player_targets()) << step;
      stage.end_of_time_step(kGeneratorTimeStep);
    }
  }
}

// What PolicyMotion says of its shape, before the stops.
Eigen::VectorXd PlaceIn(const PolicyMotion& motion, double time) {
  const Eigen::MatrixXd& s = motion.shape;
  const double turns = motion.frequency * time;
  if (motion.is_periodic) {
    Eigen::VectorXd place = s.col(0);
    for (Eigen::Index k = 1; 2 * k < s.cols(); ++k) {
      const double angle = 2 * pi * static_cast<double>(k) * turns;
      place += std::sin(angle) * s.col(2 * k - 1) + std::cos(angle) * s.col(2 * k);
    }
    return place;
  }
  const Eigen::Index knots = s.cols() - 1;
  const double along = std::min(turns, 1.0) * static_cast<double>(knots);
  const Eigen::Index i = std::min(static_cast<Eigen::Index>(along), knots - 1);
  const double t = along - static_cast<double>(i);
  const auto rate = [&](Eigen::Index k) -> Eigen::VectorXd {
    if (k == 0 || k == knots) return Eigen::VectorXd::Zero(s.rows());
    return (s.col(k + 1) - s.col(k - 1)) / 2;
  };
  return (2 * t * t * t - 3 * t * t + 1) * s.col(i) + (3 * t * t - 2 * t * t * t) * s.col(i + 1) +
         (t * t * t - 2 * t * t + t) * rate(i) + (t * t * t - t * t) * rate(i + 1);
}

struct MotionKind {
  std::string kind;
  std::string symmetry;
  std::string dof;
  size_t parameters;

  friend void PrintTo(const MotionKind& motion, std::ostream* out) {
    *out << motion.kind << ", " << motion.symmetry;
  }
};

class AsFunctionOfTimeTest : public testing::TestWithParam<MotionKind> {};

TEST_P(AsFunctionOfTimeTest, SaysWhereItIs) {
  GeneratorStage stage;
  stage.generator.Set("kind", GetParam().kind);
  stage.generator.Set("symmetry", GetParam().symmetry);
  stage.generator.Set("dof", GetParam().dof);
  stage.generator.Set("harmonics", int64_t{3});
  stage.generator.Set("knots", int64_t{4});
  std::vector<double> parameters(GetParam().parameters);
  for (size_t i = 0; i < parameters.size(); ++i)
    parameters[i] = std::sin(static_cast<double>(i + 1)) / 2;
  stage.generator.Set("parameters", parameters);
  stage.generator.Start();
  stage.start_of_episode();
  const PolicyMotion motion = stage.generator.AsFunctionOfTime();
  for (int step = 0; step < 400; ++step) {
    stage.start_of_time_step(kGeneratorTimeStep);
    const Eigen::VectorXd place = PlaceIn(motion, step * kGeneratorTimeStep);
    ASSERT_LT((place.cwiseMax(motion.low).cwiseMin(motion.high) - stage.joint_targets()).norm(),
              1e-12)
        << step;
    stage.end_of_time_step(kGeneratorTimeStep);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, AsFunctionOfTimeTest,
                         testing::Values(MotionKind{"periodic", "none", "5", 1 + 5 * 7},
                                         MotionKind{"periodic", "alternating", "all", 1 + 8 * 7},
                                         MotionKind{"one_shot", "none", "5", 1 + 5 * 4},
                                         MotionKind{"one_shot", "mirrored", "all", 1 + 8 * 4}));

// One hertz: a period has 200 time steps.
TEST(MotionGenerator, ThePhaseTurnsOnceInAPeriod) {
  GeneratorStage stage;
  stage.generator.Set("lowest_frequency", 1);
  stage.generator.Set("highest_frequency", 1);
  stage.generator.Set("parameters", std::vector<double>(16));
  stage.generator.Start();
  stage.start_of_episode();
  for (int step = 0; step < 300; ++step) {
    const double angle = 2 * pi * step / 200;
    EXPECT_NEAR(stage.phase()[0], std::cos(angle), 1e-12);
    EXPECT_NEAR(stage.phase()[1], std::sin(angle), 1e-12);
    stage.start_of_time_step(kGeneratorTimeStep);
    stage.end_of_time_step(kGeneratorTimeStep);
  }
}

TEST(MotionGenerator, ThePhaseOfAMotionThatIsDoneOnceEndsAtTheOtherSide) {
  GeneratorStage stage;
  stage.generator.Set("kind", std::string("one_shot"));
  stage.generator.Set("lowest_frequency", 1);
  stage.generator.Set("highest_frequency", 1);
  stage.generator.Set("parameters", std::vector<double>(1 + 5 * 6));
  stage.generator.Start();
  stage.start_of_episode();
  EXPECT_EQ(stage.phase()[0], 1);
  for (int step = 0; step < 250; ++step) {
    stage.start_of_time_step(kGeneratorTimeStep);
    stage.end_of_time_step(kGeneratorTimeStep);
    if (step + 1 == 100) {
      EXPECT_NEAR(stage.phase()[1], 1, 1e-12);
    }
  }
  EXPECT_NEAR(stage.phase()[0], -1, 1e-12);
}

TEST(MotionGenerator, AnotherNumberOfParametersIsRefused) {
  GeneratorStage stage;
  EXPECT_THAT(UserErrorOf([&] { stage.generator.Start(); }),
              AllOf(HasSubstr("`motion.parameters` are 0 numbers, and a motion like this has 16"),
                    HasSubstr("trainer export RUN --motion FILE.toml")));
}

}  // namespace
}  // namespace runtime
