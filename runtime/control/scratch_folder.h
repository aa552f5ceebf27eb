#pragma once

#include <filesystem>

namespace runtime {

// A folder of our own for files that are needed for a moment, removed with this object.
class ScratchFolder {
 public:
  ScratchFolder();  // throws UserError where none can be made
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace runtime
