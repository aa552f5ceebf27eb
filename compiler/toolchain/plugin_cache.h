// Finished plugins on disk, by the hash of what they were made from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace compiler {

// That of base/cache. Throws CallError where no variable tells.
std::filesystem::path DefaultCacheFolder();

// Whether a file holds a sealed plugin, whole and unchanged.
bool IsIntact(const std::filesystem::path& file);

// Removes a file of the cache, or a folder with the files in it. Returns false where it is still
// there, such as a folder that others have put a folder into. Follows no link.
bool RemoveEntry(const std::filesystem::path& entry);

// A folder inside the cache for one build, removed with all that is in it at the end.
class BuildFolder {
 public:
  // Creates the cache as well where needed. `pattern`: of its name, for mkdtemp(). Throws
  // CallError.
  BuildFolder(const std::filesystem::path& cache, const std::string& pattern);
  ~BuildFolder();
  BuildFolder(const BuildFolder&) = delete;
  BuildFolder& operator=(const BuildFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  // Keeps it, under another name, in place of what may have that name.
  void KeepAs(const std::filesystem::path& name);
  // The same with one of its files: nobody ever sees half of it.
  void KeepFile(const std::filesystem::path& file, const std::filesystem::path& name) const;

 private:
  std::filesystem::path path_;
};

}  // namespace compiler
