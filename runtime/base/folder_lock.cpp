#include "runtime/base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

namespace runtime {
namespace {

int OpenFolder(const std::filesystem::path& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

// What is locked where a folder cannot be: NFS locks only what can be opened for writing.
int OpenFileInstead(const std::filesystem::path& folder, int flags) {
  return open((folder / "folder.lock").c_str(), flags | O_CLOEXEC, 0666);
}

bool IsTakenByAnother(int descriptor) {
  return descriptor >= 0 && flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

std::optional<FolderLock> FolderLock::Take(const std::filesystem::path& folder) {
  FolderLock lock(OpenFolder(folder));
  if (lock.descriptor_ < 0) return std::nullopt;
  // Whoever only asks whether the lock is taken holds it for a moment: hence more than one try.
  for (int tries = 0; tries < 10; ++tries) {
    if (flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0) return lock;
    if (errno == EBADF) {
      lock = FolderLock(OpenFileInstead(folder, O_RDWR | O_CREAT));
      if (lock.descriptor_ < 0) return std::nullopt;
      continue;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return std::nullopt;
}

bool FolderLock::IsTaken(const std::filesystem::path& folder) {
  const FolderLock lock(OpenFolder(folder));
  const FolderLock file(OpenFileInstead(folder, O_RDONLY));
  return IsTakenByAnother(lock.descriptor_) || IsTakenByAnother(file.descriptor_);
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace runtime
