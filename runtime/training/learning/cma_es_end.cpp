#include "runtime/training/learning/cma_es_end.h"

#include <algorithm>
#include <istream>
#include <ostream>
#include <span>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {
namespace {

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// How many generations tell something of a search.
size_t MeaningfulCount(const CmaEs& search, int at_least) {
  return static_cast<size_t>(at_least + 30 * search.dimensions() / search.population());
}

// Whether the later ones of the last `count` values are not less than the earlier ones.
bool HasStopped(const std::vector<double>& values, size_t count) {
  const std::span<const double> last = std::span(values).last(count);
  const size_t part = 3 * count / 10;
  const auto first = last.first(part);
  const auto final = last.last(part);
  return MedianOf({final.begin(), final.end()}) >= MedianOf({first.begin(), first.end()});
}

}  // namespace

void CmaEsEnd::Note(const CmaEs& search) {
  const auto costs = search.costs();
  best_.push_back(costs.minCoeff());
  median_.push_back(MedianOf({costs.begin(), costs.end()}));
}

bool CmaEsEnd::IsReached(const CmaEs& search, double first_sigma, double least_step) const {
  constexpr double kMostStretched = 1e7;
  constexpr double kMostSpread = 1e4;
  if (best_.empty()) return false;
  return search.widest() < least_step || IsFlat(search) || IsStagnating(search) ||
         search.widest() > kMostStretched * search.narrowest() ||
         search.widest() > kMostSpread * first_sigma;
}

bool CmaEsEnd::IsFlat(const CmaEs& search) const {
  constexpr double kLeastDifference = 1e-12;
  const size_t count = MeaningfulCount(search, 10);
  if (best_.size() < count) return false;
  const auto [least, most] = std::ranges::minmax(std::span(best_).last(count));
  const double worst = search.costs().maxCoeff();
  return std::max(most, worst) - least <= kLeastDifference;
}

bool CmaEsEnd::IsStagnating(const CmaEs& search) const {
  const size_t count = std::max(MeaningfulCount(search, 120), best_.size() / 5);
  return best_.size() >= count && HasStopped(best_, count) && HasStopped(median_, count);
}

void CmaEsEnd::Save(std::ostream& out) const {
  for (const std::vector<double>* each : {&best_, &median_}) {
    SaveMatrix(out, Eigen::VectorXd::Map(each->data(), static_cast<Eigen::Index>(each->size())));
  }
}

void CmaEsEnd::Load(std::istream& in) {
  const Eigen::MatrixXd best = LoadMatrix(in);
  const Eigen::MatrixXd median = LoadMatrix(in);
  if (!in || best.size() != median.size()) return in.setstate(std::ios::failbit);
  best_.assign(best.data(), best.data() + best.size());
  median_.assign(median.data(), median.data() + median.size());
}

}  // namespace runtime
