#include "runtime/training/learning/motion_generator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
