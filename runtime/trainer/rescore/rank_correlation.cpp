#include "runtime/trainer/rescore/rank_correlation.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace runtime {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double MeanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Pearson's.
double CorrelationOf(const std::vector<double>& first, const std::vector<double>& second) {
  const double first_mean = MeanOf(first);
  const double second_mean = MeanOf(second);
  double both = 0, of_first = 0, of_second = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    const double a = first[i] - first_mean;
    const double b = second[i] - second_mean;
    both += a * b;
    of_first += a * a;
    of_second += b * b;
  }
  return of_first > 0 && of_second > 0 ? both / std::sqrt(of_first * of_second) : kNone;
}

int SignOf(double a, double b) { return a < b ? -1 : a > b ? 1 : 0; }

double KendallOf(const std::vector<double>& first, const std::vector<double>& second) {
  double agreeing = 0, of_first = 0, of_second = 0;  // pairs: less those that disagree; not equal
  for (size_t i = 0; i < first.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const int a = SignOf(first[i], first[j]);
      const int b = SignOf(second[i], second[j]);
      agreeing += a * b;
      of_first += a * a;
      of_second += b * b;
    }
  }
  return of_first > 0 && of_second > 0 ? agreeing / std::sqrt(of_first * of_second) : kNone;
}

}  // namespace

std::vector<double> RanksOf(const std::vector<double>& scores) {
  std::vector<double> ranks;
  for (const double score : scores) {
    double greater = 0, equal = 0;
    for (const double other : scores) {
      greater += other > score ? 1 : 0;
      equal += other == score ? 1 : 0;
    }
    ranks.push_back(greater + (equal + 1) / 2);
  }
  return ranks;
}

RankCorrelation RankCorrelationOf(const std::vector<double>& first,
                                  const std::vector<double>& second) {
  if (first.size() < 2) return {kNone, kNone};
  return {CorrelationOf(RanksOf(first), RanksOf(second)), KendallOf(first, second)};
}

}  // namespace runtime
