#pragma once

#include <string>

#include "runtime/analysis/probe/find.h"

namespace runtime {

// What a probe has found, for a terminal: a paragraph for each motion, the best one first.
std::string ProbeText(const ProbeResults& results);

}  // namespace runtime
