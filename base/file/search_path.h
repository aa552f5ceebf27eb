// Where files are that the programs know by name.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace file {

// share/taskc beside the running program's bin folder: what comes with the programs.
std::filesystem::path SharedFolder();
// For code that runs in another program: where it is instead. May be called at any time.
void SetSharedFolder(std::filesystem::path folder);

// The folders that the environment variable names (separated by ':'), then `installed` in
// SharedFolder().
std::vector<std::filesystem::path> SearchPath(const char* variable, std::string_view installed);

}  // namespace file
