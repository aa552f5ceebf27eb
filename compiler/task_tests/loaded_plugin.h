// A plugin in this process.
#pragma once

#include <taskc/plugin.h>

#include <filesystem>

namespace compiler {

class LoadedPlugin {
 public:
  // Loads a plugin that taskc has just built. Throws CallError where the system cannot.
  explicit LoadedPlugin(const std::filesystem::path& file);
  ~LoadedPlugin();
  LoadedPlugin(const LoadedPlugin&) = delete;
  LoadedPlugin& operator=(const LoadedPlugin&) = delete;

  const taskc_plugin& operator*() const { return *plugin_; }
  const taskc_plugin* operator->() const { return plugin_; }

 private:
  void* library_ = nullptr;
  const taskc_plugin* plugin_ = nullptr;
};

}  // namespace compiler
