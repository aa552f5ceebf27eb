// The pictures of a group of behaviors: the final behavior of its typical run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/analysis/study/results.h"

namespace runtime {

struct GroupStrip {
  int64_t episode = 0;        // of the group's typical run
  std::vector<double> times;  // of the pictures [s]
  std::string png;            // side by side (runtime/analysis/picture/snapshot_strip.h)
};

// Throws UserError where the recording cannot be read any more.
// `height`: of the strip [px].
GroupStrip DrawGroupStrip(const ExperimentResult& result, const BehaviorGroup& group, int height);

}  // namespace runtime
