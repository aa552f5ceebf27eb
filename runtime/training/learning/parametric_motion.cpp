#include "runtime/training/learning/parametric_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace runtime {

ParametricMotion::ParametricMotion(const Settings& settings, Eigen::VectorXd centers,
                                   Eigen::VectorXd halves)
    : settings_(settings),
      centers_(std::move(centers)),
      halves_(std::move(halves)),
      rest_(Eigen::VectorXd::Zero(coordinates())),
      shape_(Eigen::MatrixXd::Zero(per_coordinate(), coordinates())),
      basis_(Eigen::VectorXd::Zero(per_coordinate())),
      values_(Eigen::VectorXd::Zero(coordinates())) {}

Eigen::VectorXd ParametricMotion::Standstill(const Eigen::VectorXd& rest) const {
  Eigen::VectorXd parameters = Eigen::VectorXd::Zero(size());
  for (int i = 0; i < coordinates(); ++i) {
    const double place = std::clamp((rest[i] - centers_[i]) / halves_[i], -1.0, 1.0);
    parameters.segment(1 + i * per_coordinate(), is_periodic() ? 1 : per_coordinate())
        .setConstant(place);
  }
  return parameters;
}

void ParametricMotion::Take(const Eigen::VectorXd& parameters, const Eigen::VectorXd& rest) {
  const double ratio = settings_.highest_frequency / settings_.lowest_frequency;
  frequency_ = settings_.lowest_frequency * std::pow(ratio, (1 + parameters[0]) / 2);
  shape_ = parameters.tail(size() - 1).reshaped(per_coordinate(), coordinates());
  rest_ = (rest - centers_).cwiseQuotient(halves_);
}

Eigen::MatrixXd ParametricMotion::Columns() const {
  const Eigen::MatrixXd shape = halves_.asDiagonal() * shape_.transpose();
  if (!is_periodic()) {
    Eigen::MatrixXd columns(coordinates(), shape.cols() + 1);
    columns << halves_.cwiseProduct(rest_), shape;
    return columns.colwise() + centers_;
  }
  Eigen::MatrixXd columns = shape;
  columns.col(0) += centers_;
  for (int k = 2; k <= settings_.harmonics; ++k) columns.middleCols<2>(2 * k - 1) /= k;
  return columns;
}

const Eigen::VectorXd& ParametricMotion::At(double time) {
  FillBasis(time);
  values_.noalias() = shape_.transpose() * basis_;
  values_ = centers_ + halves_.cwiseProduct(values_ + rest_share_ * rest_);
  return values_;
}

void ParametricMotion::FillBasis(double time) {
  const double turns = frequency_ * time;
  rest_share_ = 0;
  if (is_periodic()) {
    basis_[0] = 1;
    for (int k = 1; k <= settings_.harmonics; ++k) {
      const double angle = 2 * std::numbers::pi * k * turns;
      basis_[2 * k - 1] = std::sin(angle) / k;
      basis_[2 * k] = std::cos(angle) / k;
    }
    return;
  }
  basis_.setZero();
  // Between knot `i` and the next one, where knot 0 is the rest.
  const double place = std::min(turns, 1.0) * settings_.knots;
  const int i = std::min(static_cast<int>(place), settings_.knots - 1);
  const double t = place - i;
  const double from = (1 + 2 * t) * (1 - t) * (1 - t);
  const double from_rate = t * (1 - t) * (1 - t);
  const double to_rate = t * t * (t - 1);
  const auto add = [&](int knot, double share) {
    (knot == 0 ? rest_share_ : basis_[knot - 1]) += share;
  };
  add(i, from);
  add(i + 1, 1 - from);
  // The rate at a knot is that between its neighbors; at both ends it is 0.
  if (i > 0) {
    add(i + 1, from_rate / 2);
    add(i - 1, -from_rate / 2);
  }
  if (i + 1 < settings_.knots) {
    add(i + 2, to_rate / 2);
    add(i, -to_rate / 2);
  }
}

}  // namespace runtime
