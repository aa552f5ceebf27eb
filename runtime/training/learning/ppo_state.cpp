#include "runtime/training/learning/ppo_state.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>
#include <utility>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {
namespace {

constexpr float kLargestObservation = 10;
constexpr float kFirstActions = 0.01f;  // of the mean, relative to what the network could do

std::vector<int> Sizes(int inputs, const std::vector<int>& hidden, int outputs) {
  std::vector<int> sizes = {inputs};
  sizes.insert(sizes.end(), hidden.begin(), hidden.end());
  sizes.push_back(outputs);
  return sizes;
}

// An empty list where the stream holds none that a network could have.
std::vector<int> LoadSizes(std::istream& in) {
  constexpr size_t kMostLayers = 100;
  constexpr int kLargestSize = 1 << 14;
  size_t count = 0;
  in >> count;
  if (!in || count < 2 || count > kMostLayers) return {};
  std::vector<int> sizes(count);
  for (int& size : sizes) in >> size;
  const bool is_sound =
      in && std::ranges::all_of(sizes, [](int size) { return size > 0 && size <= kLargestSize; });
  return is_sound ? sizes : std::vector<int>();
}

Eigen::VectorXd ToVector(const PpoFigures& figures, double rate_factor) {
  return Eigen::VectorXd{{figures.entropy, figures.divergence, figures.policy_loss,
                          figures.value_loss, figures.explained_variance, figures.deviation,
                          figures.learning_rate, rate_factor}};
}

}  // namespace

PpoState::PpoState(const std::vector<int>& policy_sizes, const std::vector<int>& value_sizes)
    : policy(policy_sizes),
      value(value_sizes),
      mean_optimizer(policy.mean.weights().size()),
      deviation_optimizer(policy.log_deviations.size()),
      value_optimizer(value.weights().size()),
      observations(policy_sizes.front()),
      returns(1),
      batch(policy_sizes.front(), policy_sizes.back()) {}

PpoState::PpoState(int observation_size, int action_size, const std::vector<int>& hidden,
                   double deviation, Random& random)
    : PpoState(Sizes(observation_size, hidden, action_size), Sizes(observation_size, hidden, 1)) {
  policy.mean.Randomize(kFirstActions, random);
  policy.log_deviations.setConstant(static_cast<float>(std::log(deviation)));
  value.Randomize(1, random);
}

void PpoState::Normalize(Eigen::Ref<Eigen::MatrixXf> matrix) const {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const auto mean = static_cast<float>(observations.Mean(i));
    const auto factor = static_cast<float>(1 / observations.Deviation(i));
    matrix.row(i) = ((matrix.row(i).array() - mean) * factor)
                        .max(-kLargestObservation)
                        .min(kLargestObservation);
  }
}

PolicyGraph::Value PpoState::AddPolicy(PolicyGraph& graph, PolicyGraph::Value observation) const {
  const Eigen::Index size = observations.size();
  Eigen::VectorXf mean(size), factor(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    mean[i] = static_cast<float>(observations.Mean(i));
    factor[i] = static_cast<float>(1 / observations.Deviation(i));
  }
  const Eigen::VectorXf limit = Eigen::VectorXf::Constant(size, kLargestObservation);
  PolicyGraph::Value result = graph.Add(PolicyGraph::Normalize{observation, mean, factor});
  result = graph.Add(PolicyGraph::Clamp{result, -limit, limit});
  const size_t layers = policy.mean.layer_count();
  for (size_t i = 0; i < layers; ++i) {
    result = graph.Add(
        PolicyGraph::Affine{result, policy.mean.LayerWeights(i), policy.mean.LayerBiases(i)});
    if (i + 1 < layers) result = graph.Add(PolicyGraph::Tanh{result});
  }
  return result;
}

void PpoState::ForgetValue(Random& random) {
  value.Randomize(1, random);
  value_optimizer = Adam<float>(value.weights().size());
}

void PpoState::ForgetScale() { returns = RunningMoments(1); }

void PpoState::ForgetOptimizers() {
  mean_optimizer = Adam<float>(policy.mean.weights().size());
  deviation_optimizer = Adam<float>(policy.log_deviations.size());
  value_optimizer = Adam<float>(value.weights().size());
  rate_factor = 1;
}

void PpoState::ActLike(const PpoState& other) {
  policy = other.policy;
  observations = other.observations;
  if (!batch.IsLike(other.batch))
    batch = DecisionBatch(other.observation_size(), other.action_size());
  batch.Clear();
}

void PpoState::Save(std::ostream& out) const {
  for (const Mlp<float>* network : {&policy.mean, &value}) {
    out << network->sizes().size() << ' ';
    for (const int size : network->sizes()) out << size << ' ';
  }
  SaveVector(out, policy.mean.weights());
  SaveVector(out, policy.log_deviations);
  SaveVector(out, value.weights());
  mean_optimizer.Save(out);
  deviation_optimizer.Save(out);
  value_optimizer.Save(out);
  observations.Save(out);
  returns.Save(out);
  out << decisions << ' ';
  SaveVector(out, ToVector(figures, rate_factor));
  batch.Save(out);
}

PpoState PpoState::Load(std::istream& in) {
  const std::vector<int> policy_sizes = LoadSizes(in);
  const std::vector<int> value_sizes = LoadSizes(in);
  if (policy_sizes.empty() || value_sizes.empty() || value_sizes.back() != 1 ||
      value_sizes.front() != policy_sizes.front()) {
    in.setstate(std::ios::failbit);
    return {};
  }
  PpoState state(policy_sizes, value_sizes);
  LoadVector(in, state.policy.mean.weights());
  LoadVector(in, state.policy.log_deviations);
  LoadVector(in, state.value.weights());
  state.mean_optimizer.Load(in);
  state.deviation_optimizer.Load(in);
  state.value_optimizer.Load(in);
  state.observations.Load(in);
  state.returns.Load(in);
  in >> state.decisions;
  Eigen::VectorXd numbers = ToVector(state.figures, state.rate_factor);
  LoadVector(in, numbers);
  state.figures = {numbers[0], numbers[1], numbers[2], numbers[3],
                   numbers[4], numbers[5], numbers[6]};
  state.rate_factor = numbers[7];
  state.batch.Load(in);
  return state;
}

}  // namespace runtime
