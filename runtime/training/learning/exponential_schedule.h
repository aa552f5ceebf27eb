#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace runtime {

// A quantity that falls from episode to episode: max(minimum, initial * exp(-decay * episode)),
// where `episode` counts the finished ones, from 0.
struct ExponentialSchedule {
  double initial = 1;
  double decay = 0;
  double minimum = 0;

  double At(int64_t episode) const {
    return std::max(minimum, initial * std::exp(-decay * static_cast<double>(episode)));
  }
};

}  // namespace runtime
