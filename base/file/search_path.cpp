#include "base/file/search_path.h"

#include <cstdlib>
#include <mutex>
#include <string>
#include <utility>

namespace file {
namespace {

struct Known {
  std::mutex mutex;
  std::filesystem::path folder;  // "": as the program says
};

Known& TheFolder() {
  static Known known;
  return known;
}

}  // namespace

void SetSharedFolder(std::filesystem::path folder) {
  const std::lock_guard lock(TheFolder().mutex);
  TheFolder().folder = std::move(folder);
}

std::filesystem::path SharedFolder() {
  {
    const std::lock_guard lock(TheFolder().mutex);
    if (!TheFolder().folder.empty()) return TheFolder().folder;
  }
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share/taskc";
}

std::vector<std::filesystem::path> SearchPath(const char* variable, std::string_view installed) {
  std::vector<std::filesystem::path> folders;
  if (const char* path = std::getenv(variable)) {
    for (std::string_view rest = path; !rest.empty();) {
      const size_t end = rest.find(':');
      if (end != 0) folders.emplace_back(rest.substr(0, end));
      rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    }
  }
  folders.push_back(SharedFolder() / installed);
  return folders;
}

}  // namespace file
