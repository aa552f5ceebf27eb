#pragma once

#include <exception>
#include <string>
#include <utility>

namespace host {

// What is wrong with a file that is to be a compiled task.
enum class PluginDefect {
  kUnreadable,  // it is missing, no regular file, too large, or cannot be copied to memory
  kNotATask,    // no shared object for this machine, or one without the entry of a task
  kUnsealed,    // taskc has not built it, and nobody has sealed it
  kDamaged,     // it is cut off or changed, cannot be loaded, or its table makes no sense
  kOtherAbi     // built for another version of the ABI
};

// The message names the file and says what to do.
class PluginError : public std::exception {
 public:
  PluginError(PluginDefect defect, std::string message)
      : defect_(defect), message_(std::move(message)) {}
  PluginDefect defect() const { return defect_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  PluginDefect defect_;
  std::string message_;
};

}  // namespace host
