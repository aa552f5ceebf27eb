// Finished plugins on disk, by the hash of what they were made from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace compiler {

// That of plugins/cache. Throws CallError where no variable tells.
std::filesystem::path DefaultCacheFolder();

// Whether a file holds a sealed plugin, whole and unchanged.
bool IsIntact(const std::filesystem::path& file);

// A folder inside the cache for one build, removed with all that is in it at the end.
class BuildFolder {
 public:
  // Creates the cache as well where needed. Throws CallError.
  explicit BuildFolder(const std::filesystem::path& cache);
  ~BuildFolder();
  BuildFolder(const BuildFolder&) = delete;
  BuildFolder& operator=(const BuildFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Keeps it, under another name, in place of what may have that name.
  void KeepAs(const std::filesystem::path& name);

 private:
  std::filesystem::path path_;
};

}  // namespace compiler
