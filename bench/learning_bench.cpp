// What learning costs per action, with the net bq01 of the humanoid: 300 features, 900 actions.
#include <benchmark/benchmark.h>

#include <vector>

#include "runtime/training/learning/boltzmann.h"
#include "runtime/training/learning/bubble_net.h"
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

}  // namespace
}  // namespace runtime
