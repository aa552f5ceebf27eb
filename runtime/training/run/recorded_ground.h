// The ground of a run's world, for who draws the recordings.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "plugins/world/world_description.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// From the texts of the task that the run began with; flat where they name no world, or are
// damaged.
world::Ground GroundOf(const RunRecord& run);

// {"normal": [x, y, z]} of the plane through the origin, with "blocks": [{"low_x", "high_x",
// "height"}] of stairs, or "hills": {"columns", "rows", "size": [x, y], "center": [x, y],
// "heights"}.
nlohmann::json GroundJson(const world::Ground& ground);

}  // namespace runtime
