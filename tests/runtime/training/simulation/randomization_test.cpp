#include "runtime/training/simulation/randomization.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "runtime/training/simulation/robot_environment.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::HasSubstr;

TEST(EpisodeRandom, DependsOnTheSeedTheEpisodeAndThePurposeAlone) {
  const EpisodeRandom random(7, 3);
  const double value = random.Uniform(1, 2);
  random.Uniform(5, 5);
  EXPECT_EQ(random.Uniform(1, 2), value);
  EXPECT_EQ(EpisodeRandom(7, 3).Uniform(1, 2), value);
  const std::set<double> all = {value,
                                EpisodeRandom(8, 3).Uniform(1, 2),
                                EpisodeRandom(7, 4).Uniform(1, 2),
                                random.Uniform(2, 2),
                                random.Uniform(1, 3),
                                random.Uniform(2, 1)};
  EXPECT_EQ(all.size(), 6u);
}

TEST(EpisodeRandom, IsUniformOrNormal) {
  constexpr int kCount = 100000;
  double uniform = 0, square = 0, normal = 0, normal_square = 0;
  for (int i = 0; i < kCount; ++i) {
    const EpisodeRandom random(1, i);
    const double u = random.Uniform(4, 0);
    const double n = random.Normal(4, 1);
    ASSERT_TRUE(0 <= u && u < 1);
    uniform += u / kCount;
    square += u * u / kCount;
    normal += n / kCount;
    normal_square += n * n / kCount;
  }
  EXPECT_NEAR(uniform, 0.5, 0.005);
  EXPECT_NEAR(square, 1. / 3, 0.005);
  EXPECT_NEAR(normal, 0, 0.02);
  EXPECT_NEAR(normal_square, 1, 0.02);
}

// The humanoid where something is random.
struct Randomized {
  explicit Randomized(const robot::RobotDescription& robot = Humanoid(), uint64_t seed = 5)
      : environment("environment", Context{&robot, {}, seed}) {
    environment.Set("profile", std::string("fast-tree"));
  }

  void Start(int64_t episode) {
    environment.SetNextEpisode(episode);
    environment.StartEpisode();
  }
  const double* Read(const char* sensor) {
    return static_cast<SensorOut&>(environment.FindPort(sensor))().reals();
  }
  double Drawn(const std::string& name) {
    for (const DrawnValue& drawn : environment.drawn())
      if (drawn.name == name) return drawn.value;
    return NAN;
  }

  RobotEnvironment environment;
};

TEST(Randomization, IsOffByDefault) {
  Randomized randomized;
  randomized.environment.Start();
  randomized.Start(1);
  EXPECT_TRUE(randomized.environment.drawn().empty());
}

TEST(Randomization, DrawsForEachEpisodeFromItsRange) {
  Randomized first;
  Randomized second;
  Randomized other(Humanoid(), 6);
  for (Randomized* each : {&first, &second, &other}) {
    each->environment.Set("random_mass", std::vector{0.5, 1.5});
    each->environment.Set("random_friction", std::vector{0.3, 0.3});
    each->environment.Start();
  }
  std::set<double> masses;
  for (const int64_t episode : {1, 2, 3, 9}) {
    first.Start(episode);
    masses.insert(first.Drawn("mass"));
    EXPECT_EQ(first.Drawn("friction"), 0.3);
    EXPECT_GE(first.Drawn("mass"), 0.5);
    EXPECT_LE(first.Drawn("mass"), 1.5);
  }
  EXPECT_EQ(masses.size(), 4u);
  second.Start(9);  // whatever was before
  EXPECT_EQ(second.Drawn("mass"), first.Drawn("mass"));
  other.Start(9);
  EXPECT_NE(other.Drawn("mass"), first.Drawn("mass"));
  EXPECT_TRUE(std::isnan(first.Drawn("gain")));
}

// What falls freely does not feel its mass; what stands weighs more on the ground.
TEST(Randomization, AHeavierRobotWeighsMore) {
  const auto weight = [](double factor) {
    Randomized randomized;
    randomized.environment.Set("random_mass", std::vector{factor, factor});
    Module listener("listener");
    SensorIn force(&listener, "contact_force", SensorTypeText("vec3[link]", "N"));
    Port::Connect(randomized.environment.FindPort("contact_force"), force);
    randomized.environment.Start();
    randomized.Start(1);
    for (int i = 0; i < 40; ++i) randomized.environment.RunTimeStep();
    double sum = 0;
    for (size_t i = 0; i < Humanoid().links.size(); ++i) sum += force().reals()[3 * i + 2];
    return sum;
  };
  double mass = 0;
  for (const robot::Link& link : Humanoid().links) mass += link.mass;
  EXPECT_NEAR(weight(1), mass * robot::kGravity, 0.1 * mass * robot::kGravity);
  EXPECT_NEAR(weight(2) / weight(1), 2, 0.2);
}

TEST(Randomization, PushesComeInTheirIntervals) {
  Randomized randomized;
  randomized.environment.Set("push_speed", 0.5);
  randomized.environment.Set("push_interval", std::vector{0.1, 0.1});
  randomized.environment.Start();
  randomized.Start(1);
  std::vector<int> pushed;
  double before = 0;
  for (int step = 0; step < 60; ++step) {
    randomized.environment.RunTimeStep();
    const double* v = randomized.Read("base.velocity");
    const double now = std::hypot(v[0], v[1]);
    if (now > before + 0.02) pushed.push_back(step);
    before = now;
  }
  ASSERT_GE(pushed.size(), 1u);
  EXPECT_GE(pushed.front(), 20);  // of 5 ms
  for (const int step : pushed) EXPECT_LE(step % 20, 1) << step;
}

class Targets : public Module {
 public:
  Targets() : Module("targets"), targets(Eigen::VectorXd::Zero(17)) {}
  Eigen::VectorXd targets;
  Out<Eigen::VectorXd> joint_targets{this, "joint_targets", &targets};
};

TEST(Randomization, TargetsComeLate) {
  Randomized randomized;
  Targets source;
  Port::Connect(source.joint_targets, randomized.environment.FindPort("joint_targets"));
  randomized.environment.Set("random_delay", std::vector{0.02, 0.02});  // 4 steps
  randomized.environment.Start();
  randomized.Start(1);
  std::vector<double> told;
  for (int step = 0; step < 8; ++step) {
    source.targets[3] = 0.01 * (step + 1);
    randomized.environment.RunTimeStep();
    told.push_back(randomized.Read("joint.target")[3]);
  }
  EXPECT_EQ(told, (std::vector{0.01, 0.01, 0.01, 0.01, 0.01, 0.02, 0.03, 0.04}));
}

TEST(Randomization, NoiseIsAddedToWhatIsSensed) {
  Randomized noisy;
  Randomized quiet;
  noisy.environment.Set("rate_noise", 0.5);
  noisy.environment.Start();
  quiet.environment.Start();
  noisy.Start(1);
  quiet.Start(1);
  double square = 0;
  int count = 0;
  for (int step = 0; step < 100; ++step) {
    noisy.environment.RunTimeStep();
    quiet.environment.RunTimeStep();
    for (size_t j = 0; j < Humanoid().joints.size(); ++j) {
      const double added = noisy.Read("joint.velocity")[j] - quiet.Read("joint.velocity")[j];
      square += added * added;
      ++count;
      EXPECT_EQ(noisy.Read("joint.angle")[j], quiet.Read("joint.angle")[j]);
    }
  }
  EXPECT_NEAR(std::sqrt(square / count), 0.5, 0.03);
}

std::string Refusal(const char* parameter, const ParameterValue& value) {
  Randomized randomized;
  try {
    randomized.environment.Set(parameter, value);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(Randomization, RefusesWhatMakesNoSense) {
  EXPECT_THAT(Refusal("random_mass", std::vector{1.5, 0.5}),
              HasSubstr("`environment.random_mass` is no range: write [lowest, highest]"));
  EXPECT_THAT(Refusal("random_friction", std::vector{1.0}), HasSubstr("is no range"));
  EXPECT_THAT(Refusal("random_mass", std::vector{0.0, 1.0}), HasSubstr("environment.random_mass"));
  EXPECT_THAT(Refusal("random_delay", std::vector{-0.1, 0.1}),
              HasSubstr("environment.random_delay"));
  EXPECT_EQ(Refusal("random_gain", std::vector<double>{}), "");
}

}  // namespace
}  // namespace runtime
