#include "runtime/base/scratch_folder.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "taskc-trainer-";
constexpr std::string_view kRandom = "XXXXXX";  // as mkdtemp() wants it

bool IsName(std::string_view name) {
  if (!name.starts_with(kPrefix) || name.size() != kPrefix.size() + kRandom.size()) return false;
  return std::ranges::all_of(name.substr(kPrefix.size()),
                             [](char c) { return std::isalnum(static_cast<unsigned char>(c)); });
}

// A folder, no link to one, that nobody but us can have made.
bool IsOurs(const fs::path& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
         status.st_uid == geteuid() && (status.st_mode & 0777) == S_IRWXU;
}

// A folder whose lock can be had belongs to a process that is gone: the system frees the lock with
// it, and numbers of processes, which are used again, tell nothing.
void RemoveLeftovers(const fs::path& parent) {
  std::error_code error;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!IsName(entry->path().filename().string()) || !IsOurs(entry->path())) continue;
    if (FolderLock::IsTaken(entry->path())) continue;
    const std::optional<FolderLock> lock = FolderLock::Take(entry->path());
    std::error_code ignored;
    if (lock) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

ScratchFolder::ScratchFolder() {
  const fs::path parent = fs::temp_directory_path();
  RemoveLeftovers(parent);
  // Before we have the lock, another trainer may take the folder for a leftover. Where the file
  // system knows no locks, nobody does.
  do {
    std::string name = parent / (std::string(kPrefix) + std::string(kRandom));
    if (mkdtemp(name.data()) == nullptr) {
      throw UserError(
          fmt::format("{}: cannot make a temporary folder: {}; set TMPDIR to another place", name,
                      std::strerror(errno)));
    }
    path_ = name;
    lock_ = FolderLock::Take(path_);
  } while (!IsOurs(path_));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  // The C library tries to unlink the folder as if it were a file, which the sandbox refuses.
  rmdir(path_.c_str());
}

}  // namespace runtime
