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

struct TaskBuild {
  std::filesystem::path task;
  std::filesystem::path plugin;       // is written
  std::filesystem::path robots = {};  // where to look for robots first; empty: nowhere
  std::filesystem::path text = {};    // holds the text of `task`; empty: `task` itself does
};

// Runs `taskc build`; returns whether the plugin was written. What the compiler says goes to
// `messages`, or else to the user as it is. `stop` ends it.
bool BuildTask(const TaskBuild& build, std::string* messages = nullptr,
               const std::stop_token& stop = {});

}  // namespace runtime
