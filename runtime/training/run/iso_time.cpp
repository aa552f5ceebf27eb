#include "runtime/training/run/iso_time.h"

#include <fmt/chrono.h>

#include <chrono>

namespace runtime {

std::string IsoTimeNow() {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", now);
}

}  // namespace runtime
