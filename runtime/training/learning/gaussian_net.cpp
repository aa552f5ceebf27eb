#include "runtime/training/learning/gaussian_net.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace runtime {
namespace {

double LargestFiniteDeviation(const Eigen::VectorXd& deviations) {
  double largest = 0;
  for (const double deviation : deviations) {
    if (deviation < GaussianNet::kInfiniteDeviation) largest = std::max(largest, deviation);
  }
  return largest > 0 ? largest : GaussianNet::kInfiniteDeviation;
}

Eigen::VectorXd NeighborDistances(const Eigen::MatrixXd& centers, double at_least, Norm norm) {
  const Eigen::MatrixXd points = centers.transpose();  // one center's elements side by side
  const Eigen::Index units = points.cols();
  Eigen::VectorXd nearest =
      Eigen::VectorXd::Constant(units, std::numeric_limits<double>::infinity());
  for (Eigen::Index k = 0; k < units; ++k) {
    for (Eigen::Index m = k + 1; m < units; ++m) {
      const double distance = Length(points.col(k) - points.col(m), norm);
      nearest[k] = std::min(nearest[k], distance);
      nearest[m] = std::min(nearest[m], distance);
    }
  }
  if (units == 1) nearest[0] = 0;  // no other unit
  return nearest.cwiseMax(at_least);
}

}  // namespace

GaussianNet::GaussianNet(Eigen::MatrixXd centers, Eigen::VectorXd deviations, Norm norm)
    : centers_(std::move(centers)),
      deviations_(std::move(deviations)),
      exponent_factors_(-0.5 * deviations_.array().square().inverse()),
      neighbor_distances_(NeighborDistances(centers_, LargestFiniteDeviation(deviations_), norm)) {
  assert(centers_.rows() > 0 && centers_.cols() == deviations_.size());
  assert((deviations_.array() > 0).all());
}

void GaussianNet::Evaluate(const Eigen::Ref<const Eigen::VectorXd>& point,
                           Eigen::VectorXd& features) const {
  assert(point.size() == dimensions() && features.size() == units());
  features.setZero();
  for (int i = 0; i < dimensions(); ++i) {
    features.array() += exponent_factors_[i] * (centers_.col(i).array() - point[i]).square();
  }
  // With the largest logarithm taken off, the largest G is 1: the sum can neither vanish nor
  // overflow however far the point lies from all centers.
  const double largest = features.maxCoeff();
  features.array() = (features.array() - largest).exp();
  const double sum = features.sum();
  features /= sum;
}

}  // namespace runtime
