#pragma once

#include <string>

namespace runtime {

// The present time to the second: "2026-01-31T12:30:59Z".
std::string IsoTimeNow();

// Of such a text; 0 of any other.
double SecondsSince1970(const std::string& iso_time);

}  // namespace runtime
