#include "runtime/control/scratch_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "runtime/module/user_error.h"

namespace runtime {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "trainer-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw UserError(
        fmt::format("{}: cannot make a temporary folder: {}; set TMPDIR to another place", name,
                    std::strerror(errno)));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace runtime
