// From a task's source to a plugin, by the compiler as a program of its own.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace runtime {

// `taskc`, which lies beside the running executable.
std::filesystem::path CompilerProgram();

// Both throw UserError where the compiler cannot be run, or does not end within two minutes.

// Runs `taskc` with these words; returns whether it succeeded. What it prints goes to `output`,
// what it reports to the user as it is.
bool RunCompiler(const std::vector<std::string>& words, std::string& output);

// Runs `taskc build`; returns whether `plugin` was written. `robots`: where to look for robots
// first; may be empty. What the compiler says goes to `messages`, or else to the user as it is.
// `stop` ends it.
bool BuildTask(const std::filesystem::path& task, const std::filesystem::path& plugin,
               const std::filesystem::path& robots, std::string* messages = nullptr,
               const std::stop_token& stop = {});

}  // namespace runtime
