#include "base/file/search_path.h"

#include <cstdlib>
#include <string>

namespace file {

std::filesystem::path SharedFolder() {
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
