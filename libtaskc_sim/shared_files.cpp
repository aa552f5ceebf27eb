#include "libtaskc_sim/shared_files.h"

#include <dlfcn.h>

#include <filesystem>

#include "base/file/search_path.h"

namespace libtaskc_sim {

void FindSharedFiles() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&FindSharedFiles), &library) == 0) return;
  std::error_code error;  // what cannot be asked for is not there
  std::filesystem::path folder = std::filesystem::canonical(library.dli_fname, error);
  for (folder = folder.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    const std::filesystem::path shared = folder / "share/taskc";
    if (std::filesystem::is_directory(shared / "robots", error)) {
      return file::SetSharedFolder(shared);
    }
  }
}

}  // namespace libtaskc_sim
