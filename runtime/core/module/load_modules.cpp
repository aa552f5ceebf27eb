#include "runtime/core/module/load_modules.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "runtime/core/module/module_library.h"

namespace runtime {
namespace {

constexpr const char* kBuildAgain =
    "build it again, with the headers and the compiler of this trainer";

[[noreturn]] void RefuseLibrary(const std::filesystem::path& library, const std::string& why) {
  throw UserError(fmt::format("{}: {}", library.string(), why));
}

const ModuleLibrary& Open(const std::filesystem::path& library) {
  if (!std::filesystem::is_regular_file(library)) {
    RefuseLibrary(library, "there is no such library of modules");
  }
  // Never closed: whatever it has made may live to the end.
  void* handle = dlopen(std::filesystem::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    RefuseLibrary(library, fmt::format("cannot be loaded: {}; {}", dlerror(), kBuildAgain));
  }
  const void* symbol = dlsym(handle, "taskc_modules");
  if (symbol == nullptr) {
    RefuseLibrary(library, "is no library of modules: it has no TASKC_MODULES(types) { ... }");
  }
  return *static_cast<const ModuleLibrary*>(symbol);
}

void CheckFits(const std::filesystem::path& library, const ModuleLibrary& modules) {
  if (modules.interface != kModuleInterface) {
    RefuseLibrary(library, fmt::format("has modules for version {} of the interface, and this "
                                       "trainer has version {}; {}",
                                       modules.interface, kModuleInterface, kBuildAgain));
  }
  if (std::string_view(modules.compiler) != __VERSION__) {
    RefuseLibrary(library, fmt::format("was made by the compiler {}, and this trainer by {}; {}",
                                       modules.compiler, __VERSION__, kBuildAgain));
  }
}

}  // namespace

void LoadModules(const std::filesystem::path& library, ModuleTypes& types) {
  const ModuleLibrary& modules = Open(library);
  CheckFits(library, modules);
  ModuleTypes added;
  modules.add(added);
  const std::vector<std::string> known = types.names();
  for (const std::string& type : added.names()) {
    if (std::ranges::find(known, type) != known.end()) {
      RefuseLibrary(library, fmt::format("there is a type of modules `{}` already; call its own "
                                         "otherwise",
                                         type));
    }
    types.Add(type, added.Find(type));
  }
}

}  // namespace runtime
