#include "runtime/training/learning/q_lambda.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "runtime/training/learning/boltzmann.h"

namespace runtime {
namespace {

// Of theta, in one step, for a feature of 1: beyond all that rewards can be worth, and so far from
// the largest number that no sum of such steps gets there.
constexpr double kLargestStep = 1e100;

}  // namespace

QLambda::QLambda(int actions, int features) : QLambda(Matrix(Matrix::Zero(actions, features))) {}

QLambda::QLambda(Matrix theta)
    : theta_(std::move(theta)),
      traces_(Matrix::Zero(theta_.rows(), theta_.cols())),
      is_traced_(theta_.rows(), 0),
      values_(theta_.rows()),
      probabilities_(theta_.rows()) {
  traced_actions_.reserve(theta_.rows());
  current_.features.resize(theta_.cols());
  next_.features.resize(theta_.cols());
}

void QLambda::StartEpisode(const Eigen::VectorXd& features, double temperature, Random& random) {
  ClearTraces();
  Select(features, temperature, random);
  std::swap(current_, next_);
}

void QLambda::ClearTraces() {
  for (const int action : traced_actions_) {
    traces_.row(action).setZero();
    is_traced_[action] = 0;
  }
  traced_actions_.clear();
}

void QLambda::Forget() {
  ClearTraces();
  theta_.setZero();
}

bool QLambda::Step(double reward, const Settings& settings, double learning_rate,
                   const Eigen::VectorXd& features, double temperature, Random& random) {
  Select(features, temperature, random);
  const bool has_learned = Learn(reward, settings, learning_rate, next_.state_value);
  std::swap(current_, next_);
  return has_learned;
}

bool QLambda::EndEpisode(double reward, const Settings& settings, double learning_rate) {
  return Learn(reward, settings, learning_rate, 0);
}

void QLambda::Select(const Eigen::VectorXd& features, double temperature, Random& random) {
  assert(features.size() == theta_.cols());
  values_.noalias() = theta_ * features;
  BoltzmannProbabilities(values_, temperature, probabilities_);
  next_.features = features;
  next_.action = SampleCategorical(probabilities_, random.Uniform());
  next_.action_value = values_[next_.action];
  next_.state_value = values_.maxCoeff();
}

bool QLambda::Learn(double reward, const Settings& settings, double learning_rate,
                    double next_value) {
  const double target = reward + settings.discount * next_value;
  const double trace_step = learning_rate * (target - current_.state_value);
  const double action_step = learning_rate * (target - current_.action_value);
  const bool is_sound =
      std::abs(trace_step) <= kLargestStep && std::abs(action_step) <= kLargestStep;
  if (!is_sound) return false;

  const int taken = current_.action;
  for (const int action : traced_actions_) theta_.row(action) += trace_step * traces_.row(action);
  theta_.row(taken) += action_step * current_.features.transpose();

  if (!is_traced_[taken]) {
    is_traced_[taken] = 1;
    traced_actions_.push_back(taken);
  }
  traces_.row(taken) += current_.features.transpose();
  const double decay = settings.discount * settings.trace_decay;
  for (const int action : traced_actions_) {
    traces_.row(action) = (decay * traces_.row(action)).cwiseMin(settings.trace_max);
  }
  return true;
}

}  // namespace runtime
