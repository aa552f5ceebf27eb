// Values with their units, as a page has them: without a place to break the line.
#pragma once

#include <string>

#include "compiler/check/unit.h"

namespace compiler {

std::string UnitText(const Unit& unit);  // empty where there is none
std::string WithUnit(const std::string& text, const Unit& unit);
std::string ToText(double value);
// "-1 .. 2 m"; empty where there are no bounds.
std::string RangeText(double low, double high, const Unit& unit);

}  // namespace compiler
