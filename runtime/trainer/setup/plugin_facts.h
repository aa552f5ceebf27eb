// What must be known of a task before its plugin is loaded here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/core/task/plugin.h"

namespace runtime {

struct PluginFacts {
  std::string robot;  // "": none
  std::string source_hash;
  std::string compiler;
  std::vector<std::filesystem::path> sources;  // the task's files
};

PluginFacts FactsOf(const Plugin& plugin);

// Loads the plugin in a process of its own, in the sandbox, so that none of its code runs here. Its
// constructors have 10 s of CPU time. To be called where there are no other threads. Throws
// UserError for whatever Plugin refuses.
PluginFacts ReadPluginFacts(const std::filesystem::path& plugin);

}  // namespace runtime
