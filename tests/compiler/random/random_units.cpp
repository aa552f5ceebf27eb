#include "tests/compiler/random/random_units.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "compiler/check/unit.h"

namespace compiler {
namespace {

struct Factor {
  std::string_view name;
  int power;
};

std::vector<Factor> FactorsOf(const Unit& unit) {
  return {{"m", unit.meter}, {"kg", unit.kilogram}, {"s", unit.second}, {"rad", unit.radian}};
}

std::string Power(const Factor& factor, int power) {
  return power == 1 ? std::string(factor.name) : fmt::format("{}^{}", factor.name, power);
}

}  // namespace

bool IsSmall(const Unit& unit) {
  for (const Factor& factor : FactorsOf(unit)) {
    if (factor.power < -3 || factor.power > 3) return false;
  }
  return true;
}

std::string UnitOfLiteral(const Unit& unit) {
  std::string above;
  std::string below;
  for (const Factor& factor : FactorsOf(unit)) {
    if (factor.power > 0) above += (above.empty() ? " " : "*") + Power(factor, factor.power);
    if (factor.power < 0) below += " / " + Power(factor, -factor.power);
  }
  return above + below;
}

std::string DeclaredType(const Type& type, const Unit& unit) {
  if (IsPlain(unit)) return ToString(type);
  std::string text;
  for (const Factor& factor : FactorsOf(unit)) {
    if (factor.power != 0) text += (text.empty() ? "" : " ") + Power(factor, factor.power);
  }
  return fmt::format("{} [{}]", ToString(type), text);
}

}  // namespace compiler
