#pragma once

#include <filesystem>
#include <memory>

#include "runtime/live/server/descriptor.h"

namespace runtime {

// Notices when no trainer works on a run any more.
class TrainerEnd {
 public:
  // Throws UserError where none does now.
  explicit TrainerEnd(const std::filesystem::path& run);

  // Can be read from when the trainer has ended. One that was killed by what it runs, and is
  // started again at once, has not.
  int descriptor() const { return end_.get(); }

 private:
  Descriptor end_;
};

}  // namespace runtime
