#include "runtime/core/module/live_parameter.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "runtime/base/user_error.h"

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

NamedParameter FindParameter(const ModuleGraph& graph, const std::string& name) {
  const size_t dot = name.find('.');
  if (dot == std::string::npos) {
    throw UserError(fmt::format("`{}` is not a parameter: write MODULE.PARAMETER", name));
  }
  Module& module = graph.Find(name.substr(0, dot));
  return {module, module.FindParameter(name.substr(dot + 1))};
}

ParameterValue FitTo(const Parameter& parameter, ParameterValue value, const std::string& name) {
  if (const double* real = std::get_if<double>(&value)) return NumberFor(parameter, *real);
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr || !TakesNumber(parameter)) return value;
  return NumberFor(parameter, NumberWithUnit(*text, parameter, name));
}

void SetLive(const ModuleGraph& graph, const std::string& name, ParameterValue value) {
  const auto [module, parameter] = FindParameter(graph, name);
  if (!parameter.is_live) {
    throw UserError(fmt::format(
        "`{0}` has no effect any more: it is read when a run starts; set it in an agent file, or "
        "with `--set {0}=...`, for another run",
        name));
  }
  module.Set(parameter.name, FitTo(parameter, std::move(value), name));
}

}  // namespace runtime
