#include "libtaskc/failure.h"

#include <fmt/format.h>

#include <cstring>

namespace libtaskc {
namespace {

// Of a size of its own, so that keeping a message cannot fail.
thread_local char kept[1024] = "";

}  // namespace

taskc_status Keep(taskc_status status, const char* message) noexcept {
  const size_t length = std::min(std::strlen(message), sizeof kept - 1);
  std::memcpy(kept, message, length);
  kept[length] = '\0';
  return status;
}

const char* KeptMessage() noexcept { return kept; }

taskc_status StatusOf(host::PluginDefect defect) {
  switch (defect) {
    case host::PluginDefect::kUnreadable:
      return TASKC_ERROR_READ;
    case host::PluginDefect::kNotATask:
      return TASKC_ERROR_NOT_A_TASK;
    case host::PluginDefect::kUnsealed:
      return TASKC_ERROR_UNSEALED;
    case host::PluginDefect::kDamaged:
      return TASKC_ERROR_DAMAGED;
    case host::PluginDefect::kOtherAbi:
      break;
  }
  return TASKC_ERROR_OTHER_ABI;
}

void RequirePointer(const void* pointer, const char* what) {
  if (pointer == nullptr) throw Failure(TASKC_ERROR_NULL, fmt::format("{} is null", what));
}

}  // namespace libtaskc
