#include "compiler/compose/library.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "base/file/search_path.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".task";

}  // namespace

bool IsLibraryName(std::string_view path) { return !fs::path(path).has_extension(); }

fs::path ImportedFile(const fs::path& importer, std::string_view path) {
  if (!IsLibraryName(path)) return (importer.parent_path() / path).lexically_normal();
  const std::vector<fs::path> folders = LibraryFolders();
  const std::string name = std::string(path) + kExtension;
  const auto has_it = [&](const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / name, ignored);
  };
  const auto found = std::ranges::find_if(folders, has_it);
  return ((found != folders.end() ? *found : folders.back()) / name).lexically_normal();
}

std::vector<fs::path> LibraryFolders() { return file::SearchPath("TASKC_LIBRARY_PATH", "library"); }

bool IsOfLibrary(const fs::path& file) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  return std::ranges::any_of(LibraryFolders(), [&](const fs::path& folder) {
    const fs::path inside = whole.lexically_relative(fs::absolute(folder).lexically_normal());
    return !inside.empty() && *inside.begin() != "..";
  });
}

std::vector<std::string> LibraryNames() {
  std::set<std::string> names;
  for (const fs::path& folder : LibraryFolders()) {
    std::error_code error;  // a folder that cannot be read has no libraries
    using Iterator = fs::recursive_directory_iterator;
    for (Iterator at(folder, error); !error && at != Iterator(); at.increment(error)) {
      if (at->path().extension() != kExtension) continue;
      names.insert(at->path().lexically_relative(folder).replace_extension().string());
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace compiler
