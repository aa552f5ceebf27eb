// What a probe has found, as plain figures: `trainer probe --json`, and what its page shows.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/analysis/probe/find.h"

namespace runtime {

// What docs/motion_search.md describes.
nlohmann::ordered_json ProbeFigures(const ProbeResults& results);

}  // namespace runtime
