// From a task's source to a plugin, by the compiler as a program of its own.
#pragma once

#include <filesystem>

namespace runtime {

// Runs `taskc build`, which lies beside the running executable; its messages go to the user as they
// are. Returns whether `plugin` was written. Throws UserError where the compiler cannot be run.
bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin);

}  // namespace runtime
