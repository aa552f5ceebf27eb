#pragma once

#include <filesystem>
#include <set>

namespace runtime {

// The files that a task is put together from, its own and those that it imports and extends: all
// that the compiler has read, even where it found errors. Of a plugin, or where there is no
// compiler, the file itself.
std::set<std::filesystem::path> FilesOfTask(const std::filesystem::path& task);

}  // namespace runtime
