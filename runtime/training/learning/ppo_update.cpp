#include "runtime/training/learning/ppo_update.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/training/learning/gae.h"

namespace runtime {
namespace {

constexpr double kRateStep = 1.5;
constexpr double kLowestRate = 1e-5;
constexpr double kHighestRate = 1e-2;

double CurrentRate(const PpoSettings& settings, const PpoState& state) {
  if (settings.kl_target == 0) return settings.learning_rate;
  return settings.learning_rate * state.rate_factor;
}

// Makes the gradient, in its parts, at most `longest` long. Returns whether it is finite.
bool Shorten(double longest, std::initializer_list<Eigen::VectorXf*> parts) {
  double square = 0;
  for (const Eigen::VectorXf* part : parts) square += part->squaredNorm();
  const double length = std::sqrt(square);
  if (!std::isfinite(length)) return false;
  if (length > longest) {
    for (Eigen::VectorXf* part : parts) *part *= static_cast<float>(longest / length);
  }
  return true;
}

double Variance(const std::vector<int>& columns, const Eigen::VectorXf& of,
                const Eigen::VectorXf* minus) {
  double sum = 0;
  double squares = 0;
  for (const int i : columns) {
    const double x = of[i] - (minus == nullptr ? 0 : (*minus)[i]);
    sum += x;
    squares += x * x;
  }
  const auto count = static_cast<double>(columns.size());
  return std::max(0.0, squares / count - (sum / count) * (sum / count));
}

}  // namespace

double PpoSettings::ScheduledDeviation(int64_t decisions) const {
  if (decisions >= deviation_decisions) return deviation_min;
  const double share = static_cast<double>(decisions) / static_cast<double>(deviation_decisions);
  return deviation + share * (deviation_min - deviation);
}

int PpoUpdate::Learn(const PpoSettings& settings, PpoState& state, Random& random) {
  assert(state.batch.decisions() > 0);
  Prepare(settings, state);
  int passed_over = 0;
  double divergence = 0;
  for (int epoch = 0; epoch < settings.epochs; ++epoch) {
    divergence = RunEpoch(settings, state, random, passed_over);
    if (settings.kl_target > 0 && divergence > 2 * settings.kl_target) break;
  }
  state.figures.divergence = divergence;
  state.figures.learning_rate = CurrentRate(settings, state);
  AdaptRate(settings, divergence, state);
  state.decisions += state.batch.decisions();
  SetDeviations(settings, state);
  const auto raw = state.batch.observations();
  for (const int column : columns_) state.observations.Add(raw.col(column).cast<double>());
  state.batch.Clear();
  return passed_over;
}

void PpoUpdate::Prepare(const PpoSettings& settings, PpoState& state) {
  observations_ = state.batch.observations();
  actions_ = state.batch.actions();
  state.Normalize(observations_);
  values_ = state.value.Forward(observations_, pass_).transpose();
  old_means_ = state.policy.mean.Forward(observations_, pass_);
  state.policy.LogProbabilities(old_means_, actions_, old_log_probabilities_);
  samples_.old_log_deviations = state.policy.log_deviations;

  Eigen::VectorXd sum(1);
  for (const DecisionBatch::Episode& episode : state.batch.episodes()) {
    sum.setZero();
    for (int i = 0; i < episode.decisions; ++i) {
      sum[0] = settings.discount * sum[0] + state.batch.rewards()[episode.first + i];
      state.returns.Add(sum);
    }
  }
  columns_.clear();
  for (Eigen::VectorXf* each : {&rewards_, &advantages_, &targets_}) each->resize(values_.size());
  for (const DecisionBatch::Episode& episode : state.batch.episodes()) {
    EstimateEpisode(settings, state, episode);
  }
  const double variance = Variance(columns_, targets_, nullptr);
  state.figures.explained_variance =
      variance > 0 ? 1 - Variance(columns_, targets_, &values_) / variance : PpoFigures::kNone;
  NormalizeAdvantages();
}

void PpoUpdate::EstimateEpisode(const PpoSettings& settings, const PpoState& state,
                                const DecisionBatch::Episode& episode) {
  const double scale = 1 / state.returns.Deviation(0);
  const int end = episode.first + episode.decisions;
  for (int i = episode.first; i < end; ++i) {
    rewards_[i] = static_cast<float>(scale * state.batch.rewards()[i]);
    columns_.push_back(i);
  }
  if (episode.is_terminal) values_[end] = 0;
  const auto part = [&](Eigen::VectorXf& vector, int count) {
    return std::span<float>(vector.data() + episode.first, count);
  };
  EstimateAdvantages(
      part(rewards_, episode.decisions), part(values_, episode.decisions + 1),
      {static_cast<float>(settings.discount), static_cast<float>(settings.gae_lambda)},
      part(advantages_, episode.decisions));
  for (int i = episode.first; i < end; ++i) targets_[i] = advantages_[i] + values_[i];
}

void PpoUpdate::NormalizeAdvantages() {
  constexpr double kLeastVariance = 1e-12;
  double sum = 0;
  for (const int i : columns_) sum += advantages_[i];
  const auto mean = static_cast<float>(sum / static_cast<double>(columns_.size()));
  const auto factor =
      static_cast<float>(1 / std::sqrt(Variance(columns_, advantages_, nullptr) + kLeastVariance));
  for (const int i : columns_) advantages_[i] = (advantages_[i] - mean) * factor;
}

// Minibatches are equally large; the few decisions that are left over have their turn in another
// epoch. Returns how far the policy was from the old one, on average over the minibatches.
double PpoUpdate::RunEpoch(const PpoSettings& settings, PpoState& state, Random& random,
                           int& passed_over) {
  for (size_t i = columns_.size(); i > 1; --i) {
    std::swap(columns_[i - 1], columns_[static_cast<size_t>(random.Uniform() * i)]);
  }
  const auto decisions = static_cast<int>(columns_.size());
  const int minibatches = std::max(1, decisions / settings.minibatch);
  const int count = decisions / minibatches;
  const auto rate = static_cast<float>(CurrentRate(settings, state));
  const auto value_rate = static_cast<float>(settings.value_learning_rate);
  double divergence = 0;
  double policy_loss = 0;
  double value_loss = 0;
  for (int i = 0; i < minibatches; ++i) {
    Gather(columns_.data() + i * count, count);
    policy_loss += policy_loss_.Evaluate(
        state.policy, samples_,
        {static_cast<float>(settings.clip), static_cast<float>(settings.entropy_bonus)});
    divergence += policy_loss_.divergence();
    value_loss += value_loss_.Evaluate(state.value, samples_.observations, sample_targets_);
    Eigen::VectorXf& deviations = policy_loss_.deviation_gradient();
    if (!settings.learns_deviation) deviations.setZero();
    if (!Shorten(settings.gradient_max, {&policy_loss_.gradient(), &deviations}) ||
        !Shorten(settings.gradient_max, {&value_loss_.gradient()})) {
      passed_over += count;
      continue;
    }
    state.mean_optimizer.Step(policy_loss_.gradient(), rate, state.policy.mean.weights());
    if (settings.learns_deviation) {
      state.deviation_optimizer.Step(deviations, rate, state.policy.log_deviations);
    }
    state.value_optimizer.Step(value_loss_.gradient(), value_rate, state.value.weights());
  }
  state.figures.policy_loss = policy_loss / minibatches;
  state.figures.value_loss = value_loss / minibatches;
  return divergence / minibatches;
}

void PpoUpdate::Gather(const int* columns, int count) {
  samples_.observations.resize(observations_.rows(), count);
  samples_.actions.resize(actions_.rows(), count);
  samples_.old_means.resize(actions_.rows(), count);
  samples_.old_log_probabilities.resize(count);
  samples_.advantages.resize(count);
  sample_targets_.resize(count);
  for (int i = 0; i < count; ++i) {
    const int column = columns[i];
    samples_.observations.col(i) = observations_.col(column);
    samples_.actions.col(i) = actions_.col(column);
    samples_.old_means.col(i) = old_means_.col(column);
    samples_.old_log_probabilities[i] = old_log_probabilities_[column];
    samples_.advantages[i] = advantages_[column];
    sample_targets_[i] = targets_[column];
  }
}

void PpoUpdate::AdaptRate(const PpoSettings& settings, double divergence, PpoState& state) {
  if (settings.kl_target == 0 || settings.learning_rate == 0) return;
  double rate = CurrentRate(settings, state);
  if (divergence > settings.kl_target * kRateStep) rate /= kRateStep;
  if (divergence < settings.kl_target / kRateStep) rate *= kRateStep;
  state.rate_factor = std::clamp(rate, kLowestRate, kHighestRate) / settings.learning_rate;
}

void PpoUpdate::SetDeviations(const PpoSettings& settings, PpoState& state) {
  Eigen::VectorXf& logs = state.policy.log_deviations;
  const auto least = static_cast<float>(std::log(settings.deviation_min));
  if (settings.learns_deviation) {
    logs = logs.cwiseMax(least);
  } else {
    logs.setConstant(static_cast<float>(std::log(settings.ScheduledDeviation(state.decisions))));
  }
  state.figures.entropy = state.policy.Entropy();
  state.figures.deviation = std::exp(logs.mean());
}

}  // namespace runtime
