// Where the user's programs keep what need not be computed twice. Whatever is in there may vanish
// at any time.
#pragma once

#include <filesystem>
#include <optional>

namespace cache {

// $TASKC_CACHE, else $XDG_CACHE_HOME/taskc, else ~/.cache/taskc; nothing where no variable tells.
// Need not exist.
std::optional<std::filesystem::path> DefaultFolder();

// The folder in it for nets, which processes may write that must not touch the compiled tasks.
inline constexpr const char* kNets = "nets";
std::optional<std::filesystem::path> NetFolder();

}  // namespace cache
