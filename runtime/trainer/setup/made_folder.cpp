#include "runtime/trainer/setup/made_folder.h"

#include <unistd.h>

#include "runtime/training/run/run_files.h"

namespace runtime {

MadeFolder::MadeFolder(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::path missing = std::filesystem::absolute(folder).lexically_normal();
  if (!missing.has_filename()) missing = missing.parent_path();  // "runs/"
  for (; !std::filesystem::exists(missing, ignored); missing = missing.parent_path()) {
    made_.push_back(missing);
    if (missing == missing.root_path()) break;
  }
  MakeRunFolder(folder);
}

MadeFolder::~MadeFolder() {
  for (const std::filesystem::path& folder : made_) rmdir(folder.c_str());
}

}  // namespace runtime
