// The file that tells programs of the run's owner how to reach the trainer over HTTP.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/live/server/descriptor.h"

namespace runtime {

// 64 hexadecimal digits that nobody can guess.
std::string NewToken();

// control.json in a run's folder, readable by its owner only: `url`, `token` and the trainer's
// `pid`. It is there, whole, for as long as this object lives.
class ControlFile {
 public:
  // Throws UserError where it cannot be written. `folder` must outlive this object.
  ControlFile(const Descriptor& folder, uint16_t port, const std::string& token);
  ControlFile(const ControlFile&) = delete;
  ControlFile& operator=(const ControlFile&) = delete;
  ~ControlFile();

 private:
  const Descriptor& folder_;
};

}  // namespace runtime
