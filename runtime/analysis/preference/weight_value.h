#pragma once

#include <string>

namespace runtime {

// A new value of a param, rounded to what a person would write: three significant digits, or a
// whole number; within its range, and on the same side of zero.
double RoundWeight(double value, double least, double greatest, bool is_whole);

// As the task language writes a value in this unit: "0.05 m", "4 / s", "1.5 kg*m/s".
std::string ValueText(double value, const std::string& unit);

}  // namespace runtime
