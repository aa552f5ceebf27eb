// The right to write a run's folder, held by one process at a time and freed with it, even by a
// kill.
#pragma once

#include <filesystem>
#include <optional>

namespace runtime {

class FolderLock {
 public:
  // Empty if another process has the lock, or if the folder cannot be opened.
  static std::optional<FolderLock> Take(const std::filesystem::path& folder);
  static bool IsTaken(const std::filesystem::path& folder);

  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace runtime
