#pragma once

#include <utility>
#include <vector>

#include "runtime/training/learning/mlp.h"

namespace runtime {

// A policy whose actions are vectors: their mean is what a network makes of the observation, and
// each element has a standard deviation that is the same for all observations. Samples are columns.
template <class Scalar>
struct GaussianPolicy {
  using Vector = Eigen::VectorX<Scalar>;
  using Matrix = Eigen::MatrixX<Scalar>;

  GaussianPolicy() = default;
  // `sizes`: of the network. The deviations are 1.
  explicit GaussianPolicy(std::vector<int> sizes)
      : mean(std::move(sizes)), log_deviations(Vector::Zero(mean.outputs())) {}

  // log pi(action | observation), given the means for the observations.
  void LogProbabilities(const Matrix& means, const Matrix& actions, Vector& result) const;
  // Of the distribution of actions.
  Scalar Entropy() const;
  // The mean over the samples of KL(old || this): how far the policy has come from one with these
  // means and logarithms of deviations.
  Scalar DivergenceFrom(const Matrix& old_means, const Vector& old_log_deviations,
                        const Matrix& means) const;

  Mlp<Scalar> mean;
  Vector log_deviations;
};

}  // namespace runtime
