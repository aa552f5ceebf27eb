#pragma once

#include <string>

namespace runtime {

// The present time to the second: "2026-01-31T12:30:59Z".
std::string IsoTimeNow();

}  // namespace runtime
