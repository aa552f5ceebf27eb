#include "runtime/trainer/serve/task_files.h"

#include <algorithm>

namespace runtime {

std::vector<std::string> TaskFilesBelow(const std::filesystem::path& folder) {
  constexpr int kDeepest = 4;
  constexpr size_t kMost = 200;
  constexpr size_t kMostLookedAt = 20'000;  // a home folder may have any number
  using Iterator = std::filesystem::recursive_directory_iterator;
  std::vector<std::string> files;
  std::error_code error;
  size_t seen = 0;
  for (Iterator entry(folder, std::filesystem::directory_options::skip_permission_denied, error);
       !error && entry != Iterator() && ++seen < kMostLookedAt && files.size() < kMost;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      if (name.starts_with('.') || entry.depth() >= kDeepest) entry.disable_recursion_pending();
    } else if (entry->path().extension() == ".task") {
      files.push_back(entry->path().lexically_relative(folder).string());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace runtime
