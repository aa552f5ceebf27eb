#pragma once

#include <string>

#include "runtime/training/run/run_records.h"

namespace runtime {

// A made-up timeline for a recording of an episode of `task` by the humanoid: what it pays sums up
// to the episode's return and terms, and its metrics come to the episode's.
std::string SampleTimeline(const Recording& recording, const EpisodeRecord& episode,
                           const TaskRecord& task);

}  // namespace runtime
