#include "runtime/analysis/robot/shaking.h"

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

constexpr double kWindow = 0.05;  // [s]
constexpr int kFewestSteps = 4;   // with less, a straight line fits too well

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

Shaking::Shaking(size_t joints, double time_step, double from)
    : window_(std::max(kFewestSteps, static_cast<int>(std::lround(kWindow / time_step)))),
      from_(from),
      sums_(joints),
      shakes_(joints) {}

void Shaking::Add(double time, std::span<const double> rates) {
  if (time < from_) return;
  const double place = filled_ - (window_ - 1) / 2.;  // from the window's middle, in steps
  for (size_t j = 0; j < sums_.size(); ++j) {
    sums_[j].rate += rates[j];
    sums_[j].square += rates[j] * rates[j];
    sums_[j].moment += place * rates[j];
  }
  if (++filled_ == window_) EndWindow();
}

void Shaking::EndWindow() {
  const double n = window_;
  const double spread = n * (n * n - 1) / 12;  // sum of the squares of all places
  for (size_t j = 0; j < sums_.size(); ++j) {
    const Sums& sums = sums_[j];
    const double rest =
        sums.square - sums.rate * sums.rate / n - sums.moment * sums.moment / spread;
    shakes_[j].push_back(std::sqrt(std::max(rest, 0.) / n));
  }
  std::ranges::fill(sums_, Sums{});
  filled_ = 0;
}

std::pair<int, double> Shaking::Worst() const {
  std::pair<int, double> worst = {-1, 0};
  for (size_t j = 0; j < shakes_.size(); ++j) {
    if (shakes_[j].empty()) continue;
    const double shake = Median(shakes_[j]);
    if (worst.first < 0 || shake > worst.second) worst = {static_cast<int>(j), shake};
  }
  return worst;
}

}  // namespace runtime
