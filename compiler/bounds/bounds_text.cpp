#include "compiler/bounds/bounds_text.h"

#include <fmt/format.h>

#include <cmath>

namespace compiler {

std::string EndText(double end) {
  return std::isinf(end) ? "unbounded" : fmt::format("{:.4g}", end + 0.0);  // 0 rather than -0
}

std::string RangeText(const Interval& range, const Unit& unit) {
  const std::string name = ToString(unit);
  const std::string suffix = name.empty() ? "" : " " + name;
  const bool has_low = range.low > -kInfinity;
  const bool has_high = range.high < kInfinity;
  if (range.low > range.high) return "no number";
  if (has_low && range.low == range.high) return fmt::format("{}{}", EndText(range.low), suffix);
  if (has_low && has_high)
    return fmt::format("{} to {}{}", EndText(range.low), EndText(range.high), suffix);
  if (has_low) return fmt::format("at least {}{}", EndText(range.low), suffix);
  if (has_high) return fmt::format("at most {}{}", EndText(range.high), suffix);
  return "any value";
}

}  // namespace compiler
