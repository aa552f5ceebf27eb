#include "base/cache/cache_folder.h"

#include <cstdlib>
#include <string_view>

namespace cache {
namespace {

std::string_view Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::optional<std::filesystem::path> DefaultFolder() {
  if (auto folder = Environment("TASKC_CACHE"); !folder.empty()) return folder;
  if (auto folder = Environment("XDG_CACHE_HOME"); !folder.empty()) {
    return std::filesystem::path(folder) / "taskc";
  }
  if (auto folder = Environment("HOME"); !folder.empty()) {
    return std::filesystem::path(folder) / ".cache" / "taskc";
  }
  return std::nullopt;
}

std::optional<std::filesystem::path> NetFolder() {
  const std::optional<std::filesystem::path> folder = DefaultFolder();
  return folder ? std::optional(*folder / kNets) : std::nullopt;
}

}  // namespace cache
