// The values and events that modules exchange, besides plain numbers.
#pragma once

#include <Eigen/Core>

#include "runtime/core/module/port.h"

namespace runtime {

enum class EndKind { kSuccess, kFailure, kTruncated, kDiverged };

// Why an episode ends. `reason` lives as long as whoever emitted it.
struct EpisodeEnd {
  EndKind kind = EndKind::kTruncated;
  const char* reason = "";
};

template <>
struct TypeText<Eigen::VectorXd> {
  static constexpr const char* value = "vector";
};
template <>
struct TypeText<EpisodeEnd> {
  static constexpr const char* value = "episode end";
};

}  // namespace runtime
