#include "runtime/analysis/preference/preference_model.h"

#include <cmath>

namespace runtime {
namespace {

// log(1 + exp(z)), which overflows nowhere.
double Softplus(double z) { return std::max(z, 0.) + std::log1p(std::exp(-std::abs(z))); }

}  // namespace

Eigen::VectorXd TermFactors(const Eigen::MatrixXd& loads, const Eigen::VectorXd& x) {
  return (loads * x).array().exp();
}

double Advantage(const PreferenceModel& model, const Eigen::VectorXd& difference,
                 const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  const Eigen::VectorXd parts = difference.cwiseProduct(TermFactors(model.loads, x)) / model.scale;
  if (gradient != nullptr) *gradient = model.loads.transpose() * parts;
  return parts.sum();
}

double Logistic(double advantage) { return 1 / (1 + std::exp(-advantage)); }

bool Holds(const Comparison& comparison, double advantage) {
  return comparison.is_tie() ? std::abs(advantage) < 1 : advantage > 0;
}

double NegativeLogPosterior(const PreferenceModel& model, const Eigen::VectorXd& x,
                            Eigen::VectorXd* gradient) {
  const double precision = 1 / (model.prior_sd * model.prior_sd);
  double value = 0.5 * precision * x.squaredNorm();
  if (gradient != nullptr) *gradient = precision * x;
  Eigen::VectorXd slope;
  for (const Comparison& comparison : model.comparisons) {
    const double z = Advantage(model, comparison.difference, x, &slope);
    value += Softplus(z) - comparison.outcome * z;
    if (gradient != nullptr) *gradient += (Logistic(z) - comparison.outcome) * slope;
  }
  return value;
}

Eigen::MatrixXd Information(const PreferenceModel& model, const Eigen::VectorXd& x) {
  Eigen::MatrixXd information =
      Eigen::MatrixXd::Identity(x.size(), x.size()) / (model.prior_sd * model.prior_sd);
  Eigen::VectorXd slope;
  for (const Comparison& comparison : model.comparisons) {
    const double p = Logistic(Advantage(model, comparison.difference, x, &slope));
    information += p * (1 - p) * slope * slope.transpose();
  }
  return information;
}

}  // namespace runtime
