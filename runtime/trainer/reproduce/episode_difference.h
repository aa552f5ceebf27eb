// Two episodes with the same number, of a run and of its repetition.
#pragma once

#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// Of one value. Numbers have all their digits.
struct ValueDifference {
  std::string name;  // "return", "term forward", "careful: return"
  std::string recorded;
  std::string here;
};

// What differs, in the order in which an episode is told; nothing where every bit is the same. The
// times that it took are left out. `run`: of both.
std::vector<ValueDifference> DifferencesOf(const EpisodeRecord& recorded, const EpisodeRecord& here,
                                           const RunRecord& run);

}  // namespace runtime
