#include "plugins/host/metric_reducer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace host {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double InitialValue(int reduction) {
  switch (reduction) {
    case TASKC_MAX:
      return -kInfinity;
    case TASKC_MIN:
      return kInfinity;
    case TASKC_LAST:
      return kUnknown;
    default:
      return 0;
  }
}

}  // namespace

MetricReducer::MetricReducer(std::span<const taskc_metric> metrics)
    : values_(metrics.size()), time_steps_(metrics.size()) {
  for (const taskc_metric& metric : metrics) reductions_.push_back(metric.reduction);
  needs_time_steps_ = std::any_of(reductions_.begin(), reductions_.end(),
                                  [](int reduction) { return reduction != TASKC_LAST; });
  StartEpisode();
}

void MetricReducer::StartEpisode() {
  std::fill(time_steps_.begin(), time_steps_.end(), 0);
  std::transform(reductions_.begin(), reductions_.end(), values_.begin(), InitialValue);
}

void MetricReducer::EndTimeStep(std::span<const double> measured) {
  for (size_t i = 0; i < values_.size(); ++i) {
    ++time_steps_[i];
    double& value = values_[i];
    const double now = measured[i];
    switch (reductions_[i]) {
      case TASKC_SUM:
      case TASKC_MEAN:
        value += now;
        break;
      case TASKC_MAX:
        if (now > value || std::isnan(now)) value = now;
        break;
      case TASKC_MIN:
        if (now < value || std::isnan(now)) value = now;
        break;
    }
  }
}

void MetricReducer::EndEpisode(std::span<const double> measured) {
  for (size_t i = 0; i < values_.size(); ++i) {
    switch (reductions_[i]) {
      case TASKC_LAST:
        values_[i] = measured[i];
        break;
      case TASKC_MEAN:
        values_[i] /= static_cast<double>(time_steps_[i]);  // 0 / 0 without a time step
        break;
      case TASKC_MAX:
      case TASKC_MIN:
        if (time_steps_[i] == 0) values_[i] = kUnknown;
        break;
    }
  }
}

void MetricReducer::TakeOver(size_t index, const MetricReducer& other, size_t other_index) {
  values_[index] = other.values_[other_index];
  time_steps_[index] = other.time_steps_[other_index];
}

}  // namespace host
