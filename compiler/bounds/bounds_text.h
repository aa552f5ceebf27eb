// Bounds as a person reads them.
#pragma once

#include <string>

#include "compiler/bounds/interval.h"
#include "compiler/check/checked_task.h"

namespace compiler {

// "0.25", "-1e-05"; "unbounded" at an infinite end.
std::string EndText(double end);
// "-1 to 1 m", "at least 0 s", "at most 2", "any value"
std::string RangeText(const Interval& range, const Unit& unit);

}  // namespace compiler
