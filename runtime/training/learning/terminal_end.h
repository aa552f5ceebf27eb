#pragma once

#include "runtime/core/module/values.h"

namespace runtime {

// Whether the last state of an episode that ends so is worth nothing: no limit has cut it off.
inline bool IsTerminal(EndKind kind) {
  return kind == EndKind::kSuccess || kind == EndKind::kFailure;
}

}  // namespace runtime
