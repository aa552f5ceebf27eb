#pragma once

#include <sys/types.h>

#include <filesystem>

#include "runtime/base/pipe.h"

namespace runtime {

// A process that removes a file when this one ends, however it ends: also one that is in a sandbox
// by then, where it may not.
class FileRemover {
 public:
  // To be made before there are other threads. Throws UserError where the system has no process
  // left.
  explicit FileRemover(const std::filesystem::path& file);
  FileRemover(const FileRemover&) = delete;
  FileRemover& operator=(const FileRemover&) = delete;
  ~FileRemover();  // removes it now

 private:
  Pipe pipe_;
  pid_t process_ = -1;
};

}  // namespace runtime
