// What learning costs per action: with the net bq01 of the humanoid, 300 features and 900 actions;
// and by PPO, with networks of 2 x 64 units, 79 observed numbers and 5 coordinates.
#include <benchmark/benchmark.h>

#include <vector>

#include "runtime/training/learning/boltzmann.h"
#include "runtime/training/learning/bubble_net.h"
#include "runtime/training/learning/ppo_update.h"
#include "runtime/training/learning/q_lambda.h"

namespace runtime {
namespace {

constexpr int kActions = 900;
constexpr double kTemperature = 0.1;

const GaussianNet& Net() {
  static const GaussianNet net = [] {
    const auto humanoid = robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
    return BubbleNet(PackSpheres(*humanoid.FindNet("bq01"), 1), Norm::kEuclidean);
  }();
  return net;
}

Eigen::VectorXd FeaturesAt(int unit) {
  Eigen::VectorXd features(Net().units());
  Net().Evaluate(Net().centers().row(unit).transpose(), features);
  return features;
}

void MakeBubbleNet(benchmark::State& state) {
  const auto humanoid = robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        BubbleNet(PackSpheres(*humanoid.FindNet("bq01"), 1), Norm::kEuclidean));
  }
}
BENCHMARK(MakeBubbleNet)->Unit(benchmark::kMillisecond);

void Features(benchmark::State& state) {
  const Eigen::VectorXd point = Net().centers().row(7).transpose();
  Eigen::VectorXd features(Net().units());
  for (auto _ : state) {
    Net().Evaluate(point, features);
    benchmark::DoNotOptimize(features.data());
  }
}
BENCHMARK(Features);

void Selection(benchmark::State& state) {
  Random random(1);
  Eigen::VectorXd values(kActions), probabilities(kActions);
  for (double& value : values) value = random.Uniform();
  for (auto _ : state) {
    BoltzmannProbabilities(values, kTemperature, probabilities);
    benchmark::DoNotOptimize(SampleCategorical(probabilities, random.Uniform()));
  }
}
BENCHMARK(Selection);

// One selection and one update, in episodes of as many actions as the argument says (130: 20 s).
void SelectionAndUpdate(benchmark::State& state) {
  Random random(1);
  QLambda q(kActions, Net().units());
  const QLambda::Settings settings;
  std::vector<Eigen::VectorXd> features;
  for (int unit = 0; unit < Net().units(); ++unit) features.push_back(FeaturesAt(unit));
  int64_t action = 0;
  for (auto _ : state) {
    const Eigen::VectorXd& next = features[action % Net().units()];
    if (action++ % state.range(0) == 0) {
      q.StartEpisode(next, kTemperature, random);
    } else {
      q.Step(random.Uniform() - 0.5, settings, 0.1, next, kTemperature, random);
    }
  }
}
BENCHMARK(SelectionAndUpdate)->Arg(130);

constexpr int kObserved = 79;
constexpr int kCoordinates = 5;

Eigen::VectorXf RandomVector(int size, Random& random) {
  Eigen::VectorXf vector(size);
  for (float& element : vector) element = static_cast<float>(random.Normal());
  return vector;
}

void PpoDecision(benchmark::State& state) {
  Random random(1);
  const PpoState ppo(kObserved, kCoordinates, {64, 64}, 0.5, random);
  const Eigen::VectorXf observation = RandomVector(kObserved, random);
  Eigen::MatrixXf normalized;
  Mlp<float>::Pass pass;
  for (auto _ : state) {
    normalized = observation;
    ppo.Normalize(normalized);
    benchmark::DoNotOptimize(ppo.policy.mean.Forward(normalized, pass).data());
  }
}
BENCHMARK(PpoDecision);

// Five epochs over 1024 decisions, in episodes of 128.
void PpoUpdateOfABatch(benchmark::State& state) {
  Random random(1);
  PpoSettings settings;
  settings.kl_target = 0;  // all epochs
  PpoState ppo(kObserved, kCoordinates, {64, 64}, settings.deviation, random);
  PpoUpdate update;
  for (auto _ : state) {
    state.PauseTiming();
    for (int i = 1; i <= 1024; ++i) {
      ppo.batch.Add(RandomVector(kObserved, random), RandomVector(kCoordinates, random), 1);
      if (i % 128 == 0) ppo.batch.EndEpisode(RandomVector(kObserved, random), false);
    }
    state.ResumeTiming();
    update.Learn(settings, ppo, random);
  }
}
BENCHMARK(PpoUpdateOfABatch)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace runtime
