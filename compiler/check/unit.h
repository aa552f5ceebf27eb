// The algebra of units: names, products, roots, and the text that a user reads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

// A unit as it is written: `5 ms` is 5 * numerator / denominator of the SI unit. Two factors, so
// that `5 ms` is the very number 0.005: one division by 1000 is rounded once, as a literal is.
struct ScaledUnit {
  Unit unit;
  double numerator = 1;
  double denominator = 1;

  double ToSi(double value) const { return value * numerator / denominator; }
};

inline bool IsPlain(const Unit& unit) { return unit == Unit{}; }
// A function's `unit`, as it is.
inline bool IsAnyUnit(const Unit& unit) { return unit == Unit{.any = 1}; }
inline bool IsAngle(const Unit& unit) { return unit == Unit{.radian = 1}; }

// The unit called `name`: "m", "deg". Nothing for another name.
std::optional<ScaledUnit> FindUnit(std::string_view name);
// All unit names, in the order of the documentation.
std::vector<std::string> KnownUnits();

// Nothing where a power leaves the range of the representation (-128 .. 127).
std::optional<Unit> Multiply(const Unit& left, const Unit& right);
std::optional<Unit> Divide(const Unit& left, const Unit& right);
// left * right^power. Nothing also where the scale is not a finite number.
std::optional<ScaledUnit> Multiply(const ScaledUnit& left, const ScaledUnit& right, int power);

// Nothing where a power is odd.
std::optional<Unit> SquareRoot(const Unit& unit);

// What `open` is where its `unit` is `said`. Nothing where a power leaves the range.
std::optional<Unit> WithUnit(const Unit& open, const Unit& said);

// "real [m/s]"
std::string TypeText(const Type& type, const Unit& unit);

// Reads the text that ToString writes, and every other product such as "N m" or "m/s^2". Nothing
// where the text is not a unit.
std::optional<ScaledUnit> ParseUnit(std::string_view text);

}  // namespace compiler
