#include "runtime/core/task/plugin.h"

#include "plugins/host/plugin_error.h"
#include "runtime/base/user_error.h"

namespace runtime {

Plugin::Plugin(const std::filesystem::path& file, const std::filesystem::path& name) try : host
  ::Plugin(file, name) {}
catch (const host::PluginError& error) {
  throw UserError(error.what());
}

}  // namespace runtime
