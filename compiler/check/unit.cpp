#include "compiler/check/unit.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace compiler {
namespace {

struct NamedUnit {
  std::string_view name;
  ScaledUnit unit;
};

// Unit lists the powers of m, kg, s, rad in this order.
constexpr std::array kUnits = {
    NamedUnit{"m", {{1, 0, 0, 0}, 1, 1}},
    NamedUnit{"cm", {{1, 0, 0, 0}, 1, 100}},
    NamedUnit{"mm", {{1, 0, 0, 0}, 1, 1000}},
    NamedUnit{"km", {{1, 0, 0, 0}, 1000, 1}},
    NamedUnit{"s", {{0, 0, 1, 0}, 1, 1}},
    NamedUnit{"ms", {{0, 0, 1, 0}, 1, 1000}},
    NamedUnit{"us", {{0, 0, 1, 0}, 1, 1000000}},
    NamedUnit{"min", {{0, 0, 1, 0}, 60, 1}},
    NamedUnit{"kg", {{0, 1, 0, 0}, 1, 1}},
    NamedUnit{"g", {{0, 1, 0, 0}, 1, 1000}},
    NamedUnit{"N", {{1, 1, -2, 0}, 1, 1}},
    NamedUnit{"J", {{2, 1, -2, 0}, 1, 1}},
    NamedUnit{"W", {{2, 1, -3, 0}, 1, 1}},
    NamedUnit{"Hz", {{0, 0, -1, 0}, 1, 1}},
    NamedUnit{"rad", {{0, 0, 0, 1}, 1, 1}},
    NamedUnit{"deg", {{0, 0, 0, 1}, std::numbers::pi, 180}},
};

constexpr Unit kNewton{1, 1, -2, 0};
constexpr Unit kWatt{2, 1, -3, 0};

std::optional<int8_t> Power(int power) {
  if (power < std::numeric_limits<int8_t>::min() || power > std::numeric_limits<int8_t>::max())
    return std::nullopt;
  return static_cast<int8_t>(power);
}

// left * right^times
std::optional<Unit> Combine(const Unit& left, const Unit& right, int times) {
  const auto meter = Power(left.meter + times * right.meter);
  const auto kilogram = Power(left.kilogram + times * right.kilogram);
  const auto second = Power(left.second + times * right.second);
  const auto radian = Power(left.radian + times * right.radian);
  const auto any = Power(left.any + times * right.any);
  if (!meter || !kilogram || !second || !radian || !any) return std::nullopt;
  return Unit{*meter, *kilogram, *second, *radian, *any};
}

struct Factor {
  std::string_view name;
  int power;
};

std::string Write(const std::vector<Factor>& factors) {
  std::string above, below;
  for (const auto& [name, power] : factors) {
    if (power == 0) continue;
    std::string& text = power > 0 ? above : below;
    if (power < 0) {
      text += '/';
    } else if (!text.empty()) {
      text += ' ';
    }
    text += name;
    if (std::abs(power) > 1) text += fmt::format("^{}", std::abs(power));
  }
  const bool is_inverse = above.empty() && !below.empty();
  return fmt::format("{}{}{}", is_inverse ? "1" : "", above, below);
}

// Reads the factors of a unit one by one.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  std::optional<ScaledUnit> Read() {
    ScaledUnit product;
    bool divide = SkipLeadingOne();
    while (true) {
      SkipSpaces();
      if (at_ == text_.size()) return divide ? std::nullopt : std::optional(product);
      if (text_[at_] == '/' || text_[at_] == '*') {
        if (divide) return std::nullopt;
        divide = text_[at_++] == '/';
        continue;
      }
      if (!ReadFactor(divide, product)) return std::nullopt;
      divide = false;
    }
  }

 private:
  void SkipSpaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  // "1/s": the 1 stands for an empty product, and a division has to follow.
  bool SkipLeadingOne() {
    SkipSpaces();
    if (!text_.substr(at_).starts_with("1/")) return false;
    at_ += 2;
    return true;
  }

  bool ReadFactor(bool divide, ScaledUnit& product) {
    const size_t end = std::min(text_.find_first_of(" */^", at_), text_.size());
    const auto unit = FindUnit(text_.substr(at_, end - at_));
    if (!unit) return false;
    at_ = end;
    int power = 1;
    if (at_ < text_.size() && text_[at_] == '^') {
      const char* last = text_.data() + text_.size();
      const auto [stop, error] = std::from_chars(text_.data() + at_ + 1, last, power);
      if (error != std::errc{}) return false;
      at_ = static_cast<size_t>(stop - text_.data());
    }
    const auto next = Multiply(product, *unit, divide ? -power : power);
    if (next) product = *next;
    return next.has_value();
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

std::optional<ScaledUnit> FindUnit(std::string_view name) {
  for (const NamedUnit& unit : kUnits)
    if (unit.name == name) return unit.unit;
  return std::nullopt;
}

std::vector<std::string> KnownUnits() {
  std::vector<std::string> names;
  for (const NamedUnit& unit : kUnits) names.emplace_back(unit.name);
  return names;
}

std::optional<Unit> Multiply(const Unit& left, const Unit& right) {
  return Combine(left, right, 1);
}

std::optional<Unit> Divide(const Unit& left, const Unit& right) { return Combine(left, right, -1); }

std::optional<ScaledUnit> Multiply(const ScaledUnit& left, const ScaledUnit& right, int power) {
  constexpr int kLargest = std::numeric_limits<int8_t>::max();
  if (std::abs(power) > kLargest) return std::nullopt;  // also keeps the sums below within an int
  const auto unit = Combine(left.unit, right.unit, power);
  if (!unit) return std::nullopt;
  const double above = std::pow(right.numerator, std::abs(power));
  const double below = std::pow(right.denominator, std::abs(power));
  const double numerator = left.numerator * (power < 0 ? below : above);
  const double denominator = left.denominator * (power < 0 ? above : below);
  if (!std::isfinite(numerator) || !std::isfinite(denominator)) return std::nullopt;
  return ScaledUnit{*unit, numerator, denominator};
}

std::optional<Unit> SquareRoot(const Unit& unit) {
  for (const int power : {unit.meter, unit.kilogram, unit.second, unit.radian, unit.any})
    if (power % 2 != 0) return std::nullopt;
  const auto half = [](int8_t power) { return static_cast<int8_t>(power / 2); };
  return Unit{half(unit.meter), half(unit.kilogram), half(unit.second), half(unit.radian),
              half(unit.any)};
}

std::string TypeText(const Type& type, const Unit& unit) {
  const std::string text = ToString(unit);
  return text.empty() ? ToString(type) : fmt::format("{} [{}]", ToString(type), text);
}

std::optional<Unit> WithUnit(const Unit& open, const Unit& said) {
  Unit rest = open;
  rest.any = 0;
  return Combine(rest, said, open.any);
}

std::optional<ScaledUnit> ParseUnit(std::string_view text) { return UnitReader(text).Read(); }

std::string ToString(const Unit& unit) {
  if (unit == kWatt) return "W";
  // Forces and torques are met far more often than their base units.
  const bool has_force = unit.kilogram == 1 && unit.second <= kNewton.second;
  const int newton = has_force ? 1 : 0;
  return Write({{kAnyUnit, unit.any},
                {"kg", unit.kilogram - newton},
                {"N", newton},
                {"m", unit.meter - newton * kNewton.meter},
                {"rad", unit.radian},
                {"s", unit.second - newton * kNewton.second}});
}

}  // namespace compiler
