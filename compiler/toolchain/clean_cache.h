#pragma once

#include <cstdint>
#include <filesystem>

namespace compiler {

// What a cache may hold [bytes]: some ten thousand plugins.
inline constexpr uintmax_t kLargestCache = uintmax_t{256} << 20;

// Notes that a plugin of the cache was used just now.
void NoteUse(const std::filesystem::path& plugin);

// Removes what builds left behind that were killed, and then the plugins and nets (and the evidence
// of refused tasks) that were used least recently, until those in `folder` take at most `limit`
// bytes. Never touches, counts or enters what has another name or no seal: the folder may be the
// user's own. Follows no link. Leaves alone what was used within the last minute: another process
// may be about to copy it. What cannot be removed stays.
void CleanCache(const std::filesystem::path& folder, uintmax_t limit = kLargestCache);

}  // namespace compiler
