#include "runtime/training/learning/gaussian_policy.h"

#include <cmath>
#include <numbers>

namespace runtime {

template <class Scalar>
void GaussianPolicy<Scalar>::LogProbabilities(const Matrix& means, const Matrix& actions,
                                              Vector& result) const {
  const Scalar log_root = std::log(2 * std::numbers::pi_v<Scalar>) / 2;
  const Scalar constant = log_deviations.sum() + static_cast<Scalar>(means.rows()) * log_root;
  result.resize(means.cols());
  for (Eigen::Index i = 0; i < means.cols(); ++i) {
    result[i] = -((actions.col(i) - means.col(i)).array() * (-log_deviations.array()).exp())
                        .square()
                        .sum() /
                    2 -
                constant;
  }
}

template <class Scalar>
Scalar GaussianPolicy<Scalar>::Entropy() const {
  const Scalar of_standard = (1 + std::log(2 * std::numbers::pi_v<Scalar>)) / 2;
  return log_deviations.sum() + static_cast<Scalar>(log_deviations.size()) * of_standard;
}

template <class Scalar>
Scalar GaussianPolicy<Scalar>::DivergenceFrom(const Matrix& old_means,
                                              const Vector& old_log_deviations,
                                              const Matrix& means) const {
  Scalar sum = 0;
  for (Eigen::Index k = 0; k < means.rows(); ++k) {
    const Scalar variance = std::exp(2 * log_deviations[k]);
    const Scalar shift =
        (old_means.row(k) - means.row(k)).squaredNorm() / static_cast<Scalar>(means.cols());
    sum += log_deviations[k] - old_log_deviations[k] - Scalar(0.5) +
           (std::exp(2 * old_log_deviations[k]) + shift) / (2 * variance);
  }
  return sum;
}

template struct GaussianPolicy<float>;
template struct GaussianPolicy<double>;

}  // namespace runtime
