// The report of many runs: one page with the curves of each experiment, what came out of its runs,
// and the groups of behaviors in which they ended.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace runtime {

// All functions throw UserError, and take the folder of a study and the folders of its runs, some
// of which may be running.

// {"folder", "experiments": [...], "notes": [...]}, see figures.h; each experiment with its
// "curve".
nlohmann::ordered_json StudyFigures(const std::filesystem::path& folder,
                                    const std::vector<std::filesystem::path>& runs);

// Writes the page to `output` (FOLDER/report.html where it is empty) and returns its path.
std::filesystem::path WriteStudyReport(const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& runs,
                                       const std::filesystem::path& output);

}  // namespace runtime
