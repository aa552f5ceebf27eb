// The outcome of a user's preferences as plain figures: `trainer prefer DIR --json`, and what the
// reports show.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/analysis/study/preference_fit.h"

namespace runtime {

// What docs/trainer.md describes.
nlohmann::ordered_json PreferenceFigures(const PreferenceFit& fit);

}  // namespace runtime
