#include "runtime/analysis/preference/weight_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace runtime {

double RoundWeight(double value, double least, double greatest, bool is_whole) {
  const double rounded = is_whole ? std::copysign(std::max(1., std::round(std::abs(value))), value)
                                  : std::strtod(fmt::format("{:.2e}", value).c_str(), nullptr);
  return std::clamp(rounded, least, greatest);
}

std::string ValueText(double value, const std::string& unit) {
  const std::string number = fmt::format("{}", value);
  if (unit.empty()) return number;
  if (unit.starts_with("1/")) return fmt::format("{} / {}", number, unit.substr(2));
  std::string product = unit;  // taskc puts a blank between factors
  std::ranges::replace(product, ' ', '*');
  return fmt::format("{} {}", number, product);
}

}  // namespace runtime
