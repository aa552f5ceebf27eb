// The local maxima in which the runs of an experiment ended: runs whose final behaviors are alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/analysis/study/experiments.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

struct FinalRecording {
  int64_t episode = 0;
  Recording recording;
};

// The last recorded episode of a run; nothing if there is none.
std::optional<FinalRecording> ReadFinalRecording(const StudyRun& run);

struct BehaviorGroup {
  std::vector<size_t> runs;  // indices into the experiment's, ascending
  size_t typical = 0;        // the run whose behavior is least far from all others of the group
};

// A, B, … Z, AA, … for groups from 0 on.
std::string GroupName(size_t group);

// Groups of behaviors that are on average less than this far apart are one (behavior.h).
inline constexpr double kSameBehavior = 2;

// Groups the finished runs by their last recorded episodes, the largest group first. `notes`: gets
// a sentence for each run whose recording cannot be read.
std::vector<BehaviorGroup> GroupBehaviors(const StudyExperiment& experiment,
                                          std::vector<std::string>& notes);

}  // namespace runtime
