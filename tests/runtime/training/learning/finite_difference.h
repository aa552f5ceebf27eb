#pragma once

#include <Eigen/Core>

#include "runtime/training/learning/random.h"

namespace runtime {

// The derivative of loss() by `weights`, which it depends on, from differences to both sides.
template <class Loss>
Eigen::VectorXd DifferenceQuotients(Eigen::VectorXd& weights, const Loss& loss) {
  constexpr double kStep = 1e-6;
  Eigen::VectorXd quotients(weights.size());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double weight = weights[i];
    weights[i] = weight + kStep;
    const double above = loss();
    weights[i] = weight - kStep;
    const double below = loss();
    weights[i] = weight;
    quotients[i] = (above - below) / (2 * kStep);
  }
  return quotients;
}

inline Eigen::MatrixXd RandomMatrix(Eigen::Index rows, Eigen::Index columns, Random& random) {
  Eigen::MatrixXd matrix(rows, columns);
  for (double& element : matrix.reshaped()) element = random.Normal();
  return matrix;
}

}  // namespace runtime
