#include "runtime/live/control/parameter_json.h"

#include <fmt/format.h>

#include <cmath>

#include "base/variant/overloaded.h"
#include "runtime/training/run/value_json.h"

namespace runtime {

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
