#pragma once

#include <taskc/plugin.h>

#include <filesystem>

namespace host {

// Throws PluginError, naming `file` and the remedy, unless the table is one that this program can
// run: its ABI version first, then every count, pointer, code, offset and range. `file` is only
// named.
void CheckPlugin(const std::filesystem::path& file, const taskc_plugin* table);

}  // namespace host
