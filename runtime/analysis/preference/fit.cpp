#include "runtime/analysis/preference/fit.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <nlopt.hpp>
#include <vector>

namespace runtime {
namespace {

constexpr double kTolerance = 1e-9;  // of x: of a weight's ratio
constexpr int kMostSteps = 2000;
// How far the other starts are from the recorded weights, in deviations of the prior.
constexpr double kFarStart = 2;
// By how much smaller scales become until a comparison counts as either right or wrong.
constexpr double kSharpening = 0.1;
constexpr int kSharpenings = 4;
constexpr double kAsGoodAsNothing = 0.01;  // of an advantage
// Of the prior that leaves weights alone which no comparison needs, and keeps from nothing else.
constexpr double kWidePrior = 100;

std::vector<double> ToVector(const Eigen::VectorXd& x) { return {x.begin(), x.end()}; }

Eigen::VectorXd ToEigen(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

double Objective(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  const auto& model = *static_cast<const PreferenceModel*>(data);
  Eigen::VectorXd slope;
  const double value = NegativeLogPosterior(model, ToEigen(x), gradient.empty() ? nullptr : &slope);
  if (!gradient.empty()) gradient = ToVector(slope);
  return value;
}

// The local minimum of NegativeLogPosterior that is reached from `start`.
Eigen::VectorXd Descend(const PreferenceModel& model, const Eigen::VectorXd& start) {
  nlopt::opt optimizer(nlopt::LD_CCSAQ, static_cast<unsigned>(start.size()));
  optimizer.set_lower_bounds(ToVector(model.lower));
  optimizer.set_upper_bounds(ToVector(model.upper));
  optimizer.set_min_objective(Objective, const_cast<PreferenceModel*>(&model));
  optimizer.set_xtol_abs(kTolerance);
  optimizer.set_maxeval(kMostSteps);
  std::vector<double> x = ToVector(start.cwiseMax(model.lower).cwiseMin(model.upper));
  double value = 0;
  try {
    optimizer.optimize(x, value);
  } catch (const nlopt::roundoff_limited&) {
    // `x` is the minimum as exactly as the numbers allow.
  }
  return ToEigen(x);
}

// A comparison that is wrong by far pulls at no weight, so that there may be several minima.
Eigen::VectorXd Minimize(const PreferenceModel& model) {
  const Eigen::Index weights = model.loads.cols();
  std::vector<Eigen::VectorXd> starts = {Eigen::VectorXd::Zero(weights)};
  for (Eigen::Index weight = 0; weight < weights; ++weight) {
    for (const double sign : {1., -1.}) {
      starts.push_back(sign * kFarStart * model.prior_sd * Eigen::VectorXd::Unit(weights, weight));
    }
  }
  Eigen::VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& start : starts) {
    const Eigen::VectorXd x = Descend(model, start);
    const double value = NegativeLogPosterior(model, x);
    if (value >= least - kTolerance) continue;  // of equal minima, the one nearest to the start
    least = value;
    best = x;
  }
  return best;
}

}  // namespace

Fit FitWeights(const PreferenceModel& model) {
  const Eigen::VectorXd x = Minimize(model);
  const Eigen::MatrixXd information = Information(model, x);
  return {x, information.llt().solve(
                 Eigen::MatrixXd::Identity(information.rows(), information.cols()))};
}

// Where each term has one weight at most, advantages are linear in the weights, so that a smaller
// scale leads from the one minimum to the next.
std::vector<bool> HoldAtBest(const PreferenceModel& model) {
  PreferenceModel sharp = model;
  sharp.prior_sd = kWidePrior;
  Eigen::VectorXd x = Minimize(sharp);
  for (int i = 0; i < kSharpenings; ++i) {
    sharp.scale *= kSharpening;
    x = Descend(sharp, x);
  }
  std::vector<bool> holds;
  for (const Comparison& comparison : model.comparisons) {
    const double advantage = Advantage(model, comparison.difference, x);
    holds.push_back(Holds(comparison, advantage + (comparison.is_tie() ? 0 : kAsGoodAsNothing)));
  }
  return holds;
}

double ExpectedInformation(const PreferenceModel& model, const Fit& fit,
                           const Eigen::VectorXd& difference) {
  Eigen::VectorXd slope;
  const double p = Logistic(Advantage(model, difference, fit.x, &slope));
  return 0.5 * std::log1p(p * (1 - p) * slope.dot(fit.covariance * slope));
}

}  // namespace runtime
