#pragma once

#include <cstddef>
#include <span>

namespace runtime {

// Whether `content` is a plugin with a seal that does not fit it. `taskc` writes the plugin's own
// SHA-256 behind the plugin, where the dynamic loader does not look; plugins that were made
// otherwise have no seal, and nothing is known against them. A changed byte can crash the loader or
// the task, so this is looked at before anything is loaded.
bool HasBrokenSeal(std::span<const std::byte> content);

}  // namespace runtime
