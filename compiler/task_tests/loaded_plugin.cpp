#include "compiler/task_tests/loaded_plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "compiler/source/diagnostic.h"

namespace compiler {

LoadedPlugin::LoadedPlugin(const std::filesystem::path& file)
    : library_(dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr) {
    throw CallError(fmt::format("cannot load the plugin {}: {}", file.string(), dlerror()));
  }
  const auto entry = reinterpret_cast<taskc_plugin_entry>(dlsym(library_, TASKC_PLUGIN_ENTRY));
  if (entry == nullptr) {
    dlclose(library_);
    throw CallError(fmt::format("the plugin {} has no entry", file.string()));
  }
  plugin_ = entry();
}

LoadedPlugin::~LoadedPlugin() { dlclose(library_); }

}  // namespace compiler
