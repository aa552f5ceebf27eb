#include "runtime/training/learning/box_search.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {
namespace {

constexpr double kBend = 0.1;  // so far before a bound, and behind it, the parabola reaches

}  // namespace

double FoldedIntoBox(double x) {
  constexpr double kTurn = 1 + kBend;
  // Into one period, [-turn, 3 turn), whose second half is the mirror of the first.
  double folded = x - 4 * kTurn * std::floor((x + kTurn) / (4 * kTurn));
  if (folded > kTurn) folded = 2 * kTurn - folded;
  const double size = std::abs(folded);
  if (size <= 1 - kBend) return folded;
  const double place = 1 - (kTurn - size) * (kTurn - size) / (4 * kBend);
  return std::copysign(place, folded);
}

double UnfoldedFromBox(double place) {
  const double size = std::min(std::abs(place), 1.0);
  if (size <= 1 - kBend) return place;
  return std::copysign(1 + kBend - std::sqrt(4 * kBend * (1 - size)), place);
}

BoxSearch::BoxSearch(const Eigen::VectorXd& start, const Settings& settings) {
  const int population = settings.population > 0
                             ? settings.population
                             : CmaEs::DefaultPopulation(static_cast<int>(start.size()));
  Begin(start.unaryExpr(&UnfoldedFromBox), settings.sigma, population);
}

void BoxSearch::Begin(const Eigen::VectorXd& start, double sigma, int population) {
  search_ = CmaEs(start, sigma, population);
  end_ = {};
  first_sigma_ = sigma;
  FindMiddle();
}

void BoxSearch::FindMiddle() { middle_ = search_.mean().unaryExpr(&FoldedIntoBox); }

const Eigen::VectorXd& BoxSearch::Ask(const Settings& settings, Random& random) {
  if (IsAtEnd(settings)) Restart(settings, random);
  candidate_ = search_.Ask(random).unaryExpr(&FoldedIntoBox);
  return candidate_;
}

Eigen::VectorXd BoxSearch::Foresee(Random& random) const {
  return search_.Foresee(random).unaryExpr(&FoldedIntoBox);
}

int BoxSearch::foreseen(const Settings& settings) const {
  return IsAtEnd(settings) ? 0 : search_.left();
}

bool BoxSearch::IsAtEnd(const Settings& settings) const {
  return end_.IsReached(search_, first_sigma_, settings.least_step);
}

void BoxSearch::Restart(const Settings& settings, Random& random) {
  Eigen::VectorXd start(dimensions());
  for (double& each : start) each = 2 * random.Uniform() - 1;
  ++restarts_;
  generations_before_ += search_.generation();
  Begin(start, settings.sigma,
        static_cast<int>(std::lround(settings.growth * search_.population())));
}

void BoxSearch::Tell(double cost) {
  if (!search_.Tell(cost)) return;
  end_.Note(search_);
  FindMiddle();
}

void BoxSearch::ForgetCosts() {
  search_.ForgetGeneration();
  end_ = {};
}

void BoxSearch::Save(std::ostream& out) const {
  out << restarts_ << ' ' << generations_before_ << '\n';
  SaveMatrix(out, Eigen::VectorXd::Constant(1, first_sigma_));
  search_.Save(out);
  end_.Save(out);
}

void BoxSearch::Load(std::istream& in) {
  BoxSearch loaded;
  in >> loaded.restarts_ >> loaded.generations_before_;
  in.get();
  const Eigen::MatrixXd first_sigma = LoadMatrix(in);
  loaded.search_.Load(in);
  loaded.end_.Load(in);
  if (!in || first_sigma.size() != 1) return in.setstate(std::ios::failbit);
  loaded.first_sigma_ = first_sigma(0, 0);
  loaded.FindMiddle();
  *this = std::move(loaded);
}

}  // namespace runtime
