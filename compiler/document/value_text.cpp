#include "compiler/document/value_text.h"

#include <fmt/format.h>

#include <cmath>

namespace compiler {

std::string UnitText(const Unit& unit) {
  std::string text = ToString(unit);
  for (size_t at; (at = text.find(' ')) != std::string::npos;) text.replace(at, 1, "\u00a0");
  return text;
}

std::string WithUnit(const std::string& text, const Unit& unit) {
  const std::string name = UnitText(unit);
  return name.empty() ? text : text + "\u00a0" + name;
}

std::string ToText(double value) {
  if (std::isinf(value)) return value < 0 ? "-∞" : "∞";
  // -0 is no news to anybody.
  return fmt::format("{:.6g}", value == 0 ? 0.0 : value);
}

std::string RangeText(double low, double high, const Unit& unit) {
  if (std::isinf(low) && std::isinf(high)) return "";
  return WithUnit(ToText(low) + " .. " + ToText(high), unit);
}

}  // namespace compiler
