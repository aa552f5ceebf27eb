#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

// The .task files in `folder` and the folders in it, as seen from there, in alphabetical order: not
// in hidden ones nor deeper than four, and at most 200.
std::vector<std::string> TaskFilesBelow(const std::filesystem::path& folder);

}  // namespace runtime
