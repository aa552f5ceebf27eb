// Where files are that the programs know by name.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace file {

// The folders that the environment variable names (separated by ':'), then share/taskc/`installed`
// beside the running program's bin folder.
std::vector<std::filesystem::path> SearchPath(const char* variable, std::string_view installed);

}  // namespace file
