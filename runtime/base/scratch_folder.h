#pragma once

#include <filesystem>
#include <optional>

#include "runtime/base/folder_lock.h"

namespace runtime {

// A folder of our own for files that are needed for a moment, removed with this object. Those that
// killed trainers of this user have left behind are removed when the next one is made.
class ScratchFolder {
 public:
  ScratchFolder();  // throws UserError where none can be made
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<FolderLock> lock_;  // says that it is in use, until this process ends
};

}  // namespace runtime
