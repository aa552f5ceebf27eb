#include "runtime/training/run/estimate.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

// Half the width of the interval that holds the mean with a probability of 95 %.
double HalfWidth(const std::vector<double>& values, double mean) {
  const auto count = static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double error = std::sqrt(squares / (count - 1) / count);
  return error * boost::math::quantile(boost::math::students_t(count - 1), 0.975);
}

}  // namespace

nlohmann::ordered_json ToJson(const Estimate& estimate) {
  return {{"count", estimate.count}, {"mean", estimate.mean},   {"low", estimate.low},
          {"high", estimate.high},   {"least", estimate.least}, {"greatest", estimate.greatest}};
}

Estimate EstimateMean(std::span<const double> values) {
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known), [](double v) { return !std::isnan(v); });
  if (known.empty()) return {0, kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber};
  double sum = 0;
  for (const double value : known) sum += value;
  const double mean = sum / static_cast<double>(known.size());
  // That of two values is so wide that it says nothing.
  const double half = known.size() > 2 ? HalfWidth(known, mean) : kNoNumber;
  const auto [least, greatest] = std::ranges::minmax(known);
  return {static_cast<int>(known.size()), mean, mean - half, mean + half, least, greatest};
}

double Median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return kNoNumber;
  std::ranges::sort(values);
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace runtime
