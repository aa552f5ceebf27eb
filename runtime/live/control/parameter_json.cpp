#include "runtime/live/control/parameter_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/variant/overloaded.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

bool IsWhole(const Parameter& parameter) {
  return std::holds_alternative<int*>(parameter.target) ||
         std::holds_alternative<int64_t*>(parameter.target);
}

// A list takes one as a list of one.
bool IsList(const Parameter& parameter) {
  return std::holds_alternative<std::vector<double>*>(parameter.target);
}

bool TakesNumber(const Parameter& parameter) {
  return IsWhole(parameter) || std::holds_alternative<double*>(parameter.target) ||
         IsList(parameter);
}

// JSON does not tell 3.0 from 3.
ParameterValue NumberFor(const Parameter& parameter, double number) {
  constexpr double kExact = 9007199254740992;  // up to here every whole number is a double
  if (IsWhole(parameter) && number == std::floor(number) && std::abs(number) <= kExact) {
    return static_cast<int64_t>(number);
  }
  return number;
}

// "20 s", where the parameter's unit is "s".
double NumberWithUnit(const std::string& text, const Parameter& parameter,
                      const std::string& name) {
  const std::string& unit = parameter.unit;
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const char* word = rest;
  while (word != end && *word == ' ') ++word;
  if (error != std::errc() || (word != end && std::string(word, end) != unit)) {
    throw UserError(fmt::format("`{}` is a {}{}, and `{}` is not one", name,
                                IsList(parameter) ? "list of numbers" : "number",
                                unit.empty() ? "" : fmt::format(" in {}", unit), text));
  }
  return number;
}

}  // namespace

ParameterValue ValueFromJson(const nlohmann::json& json, const std::string& name) {
  std::optional<ParameterValue> value = ValueFromJson(json);
  if (value) return *std::move(value);
  if (!json.is_array()) throw UserError(fmt::format("`{}` cannot be {}", name, json.dump()));
  const auto wrong = std::ranges::find_if_not(json, &nlohmann::json::is_number);
  throw UserError(
      fmt::format("`{}`: a list holds numbers only, and {} is not one", name, wrong->dump()));
}

std::vector<double> NumbersIn(const ParameterValue& value, const std::string& name) {
  return std::visit(variant::Overloaded{
                        [](const std::vector<double>& list) { return list; },
                        [&](const std::string& text) -> std::vector<double> {
                          throw UserError(fmt::format(
                              "`{}` is made of numbers, and `{}` is not one", name, text));
                        },
                        [](auto number) { return std::vector{static_cast<double>(number)}; },
                    },
                    value);
}

ParameterValue FitTo(const Parameter& parameter, ParameterValue value, const std::string& name) {
  if (const double* real = std::get_if<double>(&value)) return NumberFor(parameter, *real);
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr || !TakesNumber(parameter)) return value;
  return NumberFor(parameter, NumberWithUnit(*text, parameter, name));
}

nlohmann::json ParameterJson(const Module& module, const Parameter& parameter) {
  nlohmann::json json = {{"name", parameter.name},
                         {"value", ToJson(module.Get(parameter.name))},
                         {"unit", parameter.unit},
                         {"doc", parameter.doc}};
  if (std::isfinite(parameter.minimum)) json["minimum"] = parameter.minimum;
  if (std::isfinite(parameter.maximum)) json["maximum"] = parameter.maximum;
  if (!parameter.choices.empty()) json["choices"] = parameter.choices;
  if (!parameter.is_live) json["live"] = false;
  return json;
}

}  // namespace runtime
