// A learned policy for other programs, as plain values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "runtime/training/learning/policy_graph.h"

namespace runtime {

struct ExportedPolicy {
  // What it is of, in words: "task", "task_hash", "robot", "profile", "run", "seed", "episode",
  // "version".
  std::vector<std::pair<std::string, std::string>> facts;
  double seconds_per_decision = 0;
  PolicyGraph graph;
};

}  // namespace runtime
