#pragma once

#include <optional>
#include <set>
#include <utility>

#include "runtime/analysis/study/preference_fit.h"

namespace runtime {

// Two groups of behaviors, by their indices, the smaller first.
using GroupPair = std::pair<size_t, size_t>;

// Which two groups the user should compare next: of those that were not compared yet and are not
// among the `skipped`, the two about whose typical runs the answer would tell most of the weights.
// Nothing if there are none.
std::optional<GroupPair> MostInformativePair(const PreferenceFit& fit,
                                             const std::set<GroupPair>& skipped);

}  // namespace runtime
