#include "runtime/training/learning/ppo_loss.h"

#include <algorithm>
#include <cmath>

namespace runtime {

template <class Scalar>
Scalar PolicyLoss<Scalar>::Evaluate(const GaussianPolicy<Scalar>& policy,
                                    const PolicySamples<Scalar>& samples,
                                    const Settings& settings) {
  const Eigen::MatrixX<Scalar>& means = policy.mean.Forward(samples.observations, pass_);
  policy.LogProbabilities(means, samples.actions, log_probabilities_);
  divergence_ = policy.DivergenceFrom(samples.old_means, samples.old_log_deviations, means);

  const Eigen::Index count = means.cols();
  weights_.resize(count);
  Scalar sum = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Scalar ratio = std::exp(log_probabilities_[i] - samples.old_log_probabilities[i]);
    const Scalar advantage = samples.advantages[i];
    const Scalar free = ratio * advantage;
    const Scalar clipped = std::clamp(ratio, 1 - settings.clip, 1 + settings.clip) * advantage;
    sum += std::min(free, clipped);
    weights_[i] = free <= clipped ? -free / static_cast<Scalar>(count) : 0;
  }

  // d log pi / d mean = (a - mean) / s^2,   d log pi / d log s = (a - mean)^2 / s^2 - 1
  mean_errors_ = samples.actions - means;
  deviation_gradient_.resize(means.rows());
  for (Eigen::Index k = 0; k < means.rows(); ++k) {
    const Scalar precision = std::exp(-2 * policy.log_deviations[k]);
    deviation_gradient_[k] =
        (mean_errors_.row(k).array().square() * precision - 1).matrix().dot(weights_.transpose()) -
        settings.entropy_bonus;
    mean_errors_.row(k).array() *= precision * weights_.transpose().array();
  }
  policy.mean.Backward(samples.observations, mean_errors_, pass_, gradient_);
  return -sum / static_cast<Scalar>(count) - settings.entropy_bonus * policy.Entropy();
}

template <class Scalar>
Scalar ValueLoss<Scalar>::Evaluate(const Mlp<Scalar>& value,
                                   const Eigen::MatrixX<Scalar>& observations,
                                   const Eigen::VectorX<Scalar>& targets) {
  errors_ = value.Forward(observations, pass_) - targets.transpose();
  const Scalar loss = errors_.squaredNorm() / static_cast<Scalar>(2 * targets.size());
  errors_ /= static_cast<Scalar>(targets.size());
  value.Backward(observations, errors_, pass_, gradient_);
  return loss;
}

template class PolicyLoss<float>;
template class PolicyLoss<double>;
template class ValueLoss<float>;
template class ValueLoss<double>;

}  // namespace runtime
