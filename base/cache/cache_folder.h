// Where the user's programs keep what need not be computed twice. Whatever is in there may vanish
// at any time.
#pragma once

#include <filesystem>
#include <optional>

namespace cache {

// $TASKC_CACHE, else $XDG_CACHE_HOME/taskc, else ~/.cache/taskc; nothing where no variable tells.
// Need not exist.
std::optional<std::filesystem::path> DefaultFolder();

}  // namespace cache
