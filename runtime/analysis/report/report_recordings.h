// The recorded episodes of a run, for the page.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/training/run/run_database.h"

namespace runtime {

// {"frames", "interval", "poses"} of a robot with `link_count` links. Throws UserError where the
// recording is damaged.
nlohmann::json EncodeRecording(const Recording& recording, size_t link_count);

// Sets data.body, data.recordings and data.notes: the links' shapes, as many recordings as fit into
// the page, each with its task, what the robot was told and paid meanwhile (report_timeline.h) and
// how it ended, and in sentences what is missing from the page. A recording that is damaged costs
// itself, never the page.
void AddRecordings(const RunDatabase& database, const RunRecord& run,
                   const std::vector<EpisodeRecord>& episodes, nlohmann::json& data);

}  // namespace runtime
