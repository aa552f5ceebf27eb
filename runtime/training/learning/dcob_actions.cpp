#include "runtime/training/learning/dcob_actions.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/base/user_error.h"

namespace runtime {

DcobActions::DcobActions(const std::string& module, std::vector<double> intervals, int units)
    : intervals_(std::move(intervals)), count_(static_cast<int>(intervals_.size()) * units) {
  if (intervals_.empty()) {
    throw UserError(fmt::format("`{}.intervals` is empty: it needs at least one number", module));
  }
  for (const double interval : intervals_) {
    if (interval > 0) continue;
    throw UserError(
        fmt::format("`{}.intervals` must be greater than 0, and {} is not", module, interval));
  }
}

void DcobActions::CheckAction(const std::string& module, int action) const {
  if (action >= 0 && action < count_) return;
  throw UserError(fmt::format("`{}` gets action {} and has {} actions: take their number from it",
                              module, action, count_));
}

void DcobActions::CheckFeatures(const std::string& module, long features, int units) {
  if (features == units) return;
  throw UserError(
      fmt::format("`{}` gets {} features and a net of {} units: take both from the same module",
                  module, features, units));
}

}  // namespace runtime
