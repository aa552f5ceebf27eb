// From a task's source to a plugin, by the compiler as a program of its own.
#pragma once

#include <filesystem>
#include <string>

namespace runtime {

// `taskc`, which lies beside the running executable.
std::filesystem::path CompilerProgram();

// Runs `taskc build`; returns whether `plugin` was
// written. What the compiler says goes to `messages`, or else to the user as it is. Throws
// UserError where the compiler cannot be run.
bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin,
               std::string* messages = nullptr);

}  // namespace runtime
