#include "runtime/training/learning/cma_es.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <numeric>
#include <ostream>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {

CmaEsSettings::CmaEsSettings(int dimensions, int population) : weights(population) {
  const double n = dimensions;
  for (int i = 0; i < population; ++i) {
    weights[i] = std::log((population + 1) / 2.0) - std::log(i + 1.0);
  }
  parents = population / 2;
  const auto best = weights.head(parents);
  const auto worst = weights.tail(population - parents);
  mu_eff = best.sum() * best.sum() / best.squaredNorm();
  const double worst_mu_eff = worst.sum() * worst.sum() / worst.squaredNorm();

  c_sigma = (mu_eff + 2) / (n + mu_eff + 5);
  d_sigma = 1 + 2 * std::max(0.0, std::sqrt((mu_eff - 1) / (n + 1)) - 1) + c_sigma;
  c_c = (4 + mu_eff / n) / (n + 4 + 2 * mu_eff / n);
  c_1 = 2 / ((n + 1.3) * (n + 1.3) + mu_eff);
  c_mu = std::min(1 - c_1, 2 * (0.25 + mu_eff + 1 / mu_eff - 2) / ((n + 2) * (n + 2) + mu_eff));

  // The negative weights are so small that C stays positive definite.
  const double negative = std::min(
      {1 + c_1 / c_mu, 1 + 2 * worst_mu_eff / (mu_eff + 2), (1 - c_1 - c_mu) / (n * c_mu)});
  const double worst_sum = -weights.cwiseMin(0.0).sum();
  const double best_sum = weights.cwiseMax(0.0).sum();
  for (double& weight : weights) weight *= weight < 0 ? negative / worst_sum : 1 / best_sum;
  expected_length = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
}

int CmaEs::DefaultPopulation(int dimensions) {
  return 4 + static_cast<int>(3 * std::log(dimensions));
}

CmaEs::CmaEs(const Eigen::VectorXd& mean, double sigma, int population)
    : mean_(mean),
      sigma_(sigma),
      covariance_(Eigen::MatrixXd::Identity(mean.size(), mean.size())),
      path_sigma_(Eigen::VectorXd::Zero(mean.size())),
      path_c_(Eigen::VectorXd::Zero(mean.size())),
      drawn_(Eigen::MatrixXd::Zero(mean.size(), population)),
      costs_(Eigen::VectorXd::Zero(population)) {
  Allocate();
  Decompose();
}

void CmaEs::Allocate() {
  settings_ = CmaEsSettings(dimensions(), population());
  order_.resize(static_cast<size_t>(population()));
  for (Eigen::VectorXd* each :
       {&solver_axes_, &mean_drawn_, &mean_step_, &rotated_, &step_, &candidate_.drawn,
        &candidate_.step, &candidate_.rotated, &candidate_.place}) {
    each->setZero(dimensions());
  }
}

void CmaEs::Decompose() {
  solver_.compute(covariance_);
  // Rounding can make an axis of length 0 one of less.
  solver_axes_ = solver_.eigenvalues().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt();
}

void CmaEs::Draw(Random& random, Candidate& candidate) const {
  for (double& each : candidate.drawn) each = random.Normal();
  candidate.step = solver_axes_.cwiseProduct(candidate.drawn);
  candidate.rotated.noalias() = solver_.eigenvectors() * candidate.step;
  candidate.place = mean_ + sigma_ * candidate.rotated;
}

const Eigen::VectorXd& CmaEs::Ask(Random& random) {
  Draw(random, candidate_);
  drawn_.col(told_ % population()) = candidate_.drawn;
  if (told_ == population()) told_ = 0;
  return candidate_.place;
}

Eigen::VectorXd CmaEs::Foresee(Random& random) const {
  Candidate candidate = candidate_;
  Draw(random, candidate);
  return candidate.place;
}

bool CmaEs::Tell(double cost) {
  costs_[told_++] = std::isnan(cost) ? std::numeric_limits<double>::infinity() : cost;
  if (told_ < population()) return false;
  FinishGeneration();
  return true;
}

void CmaEs::FinishGeneration() {
  SortCandidates();
  MoveMean();
  AdaptCovariance();
  AdaptSigma();
  ++generation_;
  Decompose();
}

// Among equal ones that which was asked for first.
void CmaEs::SortCandidates() {
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::sort(order_, [&](int a, int b) {
    return costs_[a] < costs_[b] || (costs_[a] == costs_[b] && a < b);
  });
}

void CmaEs::MoveMean() {
  mean_drawn_.setZero();
  for (int i = 0; i < settings_.parents; ++i) {
    mean_drawn_ += settings_.weights[i] * drawn_.col(order_[static_cast<size_t>(i)]);
  }
  step_ = solver_axes_.cwiseProduct(mean_drawn_);
  mean_step_.noalias() = solver_.eigenvectors() * step_;
  mean_ += sigma_ * mean_step_;
  rotated_.noalias() = solver_.eigenvectors() * mean_drawn_;
  const double c = settings_.c_sigma;
  path_sigma_ = (1 - c) * path_sigma_ + std::sqrt(c * (2 - c) * settings_.mu_eff) * rotated_;
}

void CmaEs::AdaptSigma() {
  const double excess = path_sigma_.norm() / settings_.expected_length - 1;
  sigma_ *= std::exp(settings_.c_sigma / settings_.d_sigma * excess);
}

// The mean has gone in one direction for long: then C does not learn from its path, lest it
// stretches that way before sigma has grown.
bool CmaEs::PathIsLong() const {
  const double forgotten =
      std::pow(1 - settings_.c_sigma, 2 * static_cast<double>(generation_ + 1));
  return path_sigma_.norm() / std::sqrt(1 - forgotten) >=
         (1.4 + 2.0 / (dimensions() + 1)) * settings_.expected_length;
}

void CmaEs::AdaptCovariance() {
  const bool is_long = PathIsLong();
  const auto& [weights, parents, mu_eff, c_sigma, d_sigma, c_c, c_1, c_mu, length] = settings_;
  path_c_ *= 1 - c_c;
  if (!is_long) path_c_ += std::sqrt(c_c * (2 - c_c) * mu_eff) * mean_step_;
  const double compensation = is_long ? c_1 * c_c * (2 - c_c) : 0;
  covariance_ *= 1 + compensation - c_1 - c_mu * weights.sum();
  auto lower = covariance_.selfadjointView<Eigen::Lower>();
  lower.rankUpdate(path_c_, c_1);
  for (int i = 0; i < population(); ++i) {
    const auto drawn = drawn_.col(order_[static_cast<size_t>(i)]);
    const double weight = weights[i] * (weights[i] < 0 ? dimensions() / drawn.squaredNorm() : 1.0);
    step_ = solver_axes_.cwiseProduct(drawn);
    rotated_.noalias() = solver_.eigenvectors() * step_;
    lower.rankUpdate(rotated_, c_mu * weight);
  }
}

void CmaEs::Save(std::ostream& out) const {
  out << told_ << ' ' << generation_ << '\n';
  SaveMatrix(out, Eigen::VectorXd::Constant(1, sigma_));
  for (const Eigen::VectorXd* each : {&mean_, &path_sigma_, &path_c_, &costs_}) {
    SaveMatrix(out, *each);
  }
  SaveMatrix(out, covariance_);
  SaveMatrix(out, drawn_);
}

void CmaEs::Load(std::istream& in) {
  CmaEs loaded;
  in >> loaded.told_ >> loaded.generation_;
  in.get();
  const Eigen::MatrixXd sigma = LoadMatrix(in);
  for (Eigen::VectorXd* each :
       {&loaded.mean_, &loaded.path_sigma_, &loaded.path_c_, &loaded.costs_}) {
    *each = LoadMatrix(in).reshaped();
  }
  loaded.covariance_ = LoadMatrix(in);
  loaded.drawn_ = LoadMatrix(in);
  const Eigen::Index n = loaded.mean_.size();
  const bool fits = in && sigma.size() == 1 && loaded.path_sigma_.size() == n &&
                    loaded.path_c_.size() == n && loaded.covariance_.rows() == n &&
                    loaded.covariance_.cols() == n && loaded.drawn_.rows() == n &&
                    loaded.drawn_.cols() == loaded.costs_.size() && loaded.told_ >= 0 &&
                    loaded.told_ <= loaded.costs_.size();
  if (!fits) return in.setstate(std::ios::failbit);
  loaded.sigma_ = sigma(0, 0);
  loaded.Allocate();
  loaded.Decompose();
  *this = std::move(loaded);
}

}  // namespace runtime
