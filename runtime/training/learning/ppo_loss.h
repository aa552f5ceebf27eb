// What PPO makes small in each minibatch (Schulman et al., "Proximal policy optimization
// algorithms", 2017), and the derivatives. With A_i the advantage of a decision, H the entropy,
//
//   policy: -(1/n) sum min(r_i A_i, clip(r_i, 1 - c, 1 + c) A_i) - b H,
//           r_i = pi(a_i | o_i) / pi_old(a_i | o_i)
//   value:  (1/2n) sum (v(o_i) - target_i)^2
//
// Samples are columns. Used again for as many of them, neither allocates.
#pragma once

#include "runtime/training/learning/gaussian_policy.h"

namespace runtime {

template <class Scalar>
struct PolicySamples {
  Eigen::MatrixX<Scalar> observations;
  Eigen::MatrixX<Scalar> actions;
  Eigen::VectorX<Scalar> advantages;
  // Of the policy that the actions were selected by.
  Eigen::MatrixX<Scalar> old_means;
  Eigen::VectorX<Scalar> old_log_deviations;
  Eigen::VectorX<Scalar> old_log_probabilities;
};

template <class Scalar>
class PolicyLoss {
 public:
  struct Settings {
    Scalar clip = Scalar(0.2);  // c
    Scalar entropy_bonus = 0;   // b
  };

  Scalar Evaluate(const GaussianPolicy<Scalar>& policy, const PolicySamples<Scalar>& samples,
                  const Settings& settings);

  // Of the last evaluation: the derivatives by the weights of the mean and by the logarithms of the
  // deviations, and how far the policy was from the old one.
  Eigen::VectorX<Scalar>& gradient() { return gradient_; }
  Eigen::VectorX<Scalar>& deviation_gradient() { return deviation_gradient_; }
  Scalar divergence() const { return divergence_; }

 private:
  typename Mlp<Scalar>::Pass pass_;
  Eigen::VectorX<Scalar> log_probabilities_;
  Eigen::VectorX<Scalar> weights_;  // derivatives of the loss by the log probabilities
  Eigen::MatrixX<Scalar> mean_errors_;
  Eigen::VectorX<Scalar> gradient_;
  Eigen::VectorX<Scalar> deviation_gradient_;
  Scalar divergence_ = 0;
};

template <class Scalar>
class ValueLoss {
 public:
  Scalar Evaluate(const Mlp<Scalar>& value, const Eigen::MatrixX<Scalar>& observations,
                  const Eigen::VectorX<Scalar>& targets);

  // Of the last evaluation: the derivative by the network's weights.
  Eigen::VectorX<Scalar>& gradient() { return gradient_; }

 private:
  typename Mlp<Scalar>::Pass pass_;
  Eigen::MatrixX<Scalar> errors_;
  Eigen::VectorX<Scalar> gradient_;
};

}  // namespace runtime
