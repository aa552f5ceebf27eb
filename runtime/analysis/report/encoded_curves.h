// Curves as the page reads them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/analysis/curves/task_curves.h"

namespace runtime {

// [{name, unit, reduction, doc, tasks, values}], with the indices of the tasks that have it, and a
// value, in base64, for each episode.
nlohmann::json EncodeCurves(const std::vector<Curve>& curves);

}  // namespace runtime
