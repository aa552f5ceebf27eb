// What a recorded episode paid, measured and touched, for the page.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/training/run/run_records.h"

namespace runtime {

// {"end", "returns", "terms": [{"name", "doc", "values"}], "metrics": [{"name", "unit",
// "reduction", "doc", "values"}], "phases": {"names", "values"}, "contacts"} of the first `frames`
// frames and of the episode's end (runtime/training/run/timeline.h), values and contacts in base64;
// "phases" only of a task with phases. null where the recording has no timeline. Throws UserError
// where it is damaged.
nlohmann::json EncodeTimeline(const Recording& recording, size_t frames, const TaskRecord& task,
                              size_t link_count);

}  // namespace runtime
