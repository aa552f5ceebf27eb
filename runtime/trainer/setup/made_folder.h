#pragma once

#include <filesystem>
#include <vector>

namespace runtime {

// A folder that is there before it is known whether it is needed: a sandbox can only grant what
// exists. What this object has made, with those it lies in, goes with it where it is still empty.
class MadeFolder {
 public:
  // Throws UserError where it cannot be made.
  explicit MadeFolder(const std::filesystem::path& folder);
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;
  ~MadeFolder();

 private:
  std::vector<std::filesystem::path> made_;  // from the innermost out
};

}  // namespace runtime
