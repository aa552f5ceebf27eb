// The poses of a recorded episode.
#pragma once

#include <cstddef>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// [frame][link][x y z qw qx qy qz], see schema.sql, for a robot with `link_count` links: at least
// one frame, up to the first value that is not finite, since a diverged simulation has no pose.
// Throws UserError where the recording is damaged.
std::vector<float> ReadPoses(const Recording& recording, size_t link_count);

}  // namespace runtime
