// What a user has stated about the experiments of a study, for its reports.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/analysis/study/results.h"

namespace runtime {

// To each experiment the figures of what was stated about it (preference_figures.h); null where
// nothing was. `folder`: of the study. `notes`: gets what keeps preferences from being fitted.
// Throws UserError for a mistake in preferences.toml.
std::vector<nlohmann::ordered_json> StatedPreferences(const StudyResults& study,
                                                      const std::filesystem::path& folder,
                                                      std::vector<std::string>& notes);

}  // namespace runtime
