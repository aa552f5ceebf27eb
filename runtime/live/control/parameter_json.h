// Values of parameters as clients write and read them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "runtime/core/module/module.h"

namespace runtime {

// Whether it is a whole number that int64_t holds. Beyond it, nlohmann::json wraps around.
bool IsInt64(const nlohmann::json& json);

nlohmann::json ToJson(const ParameterValue& value);

// A number may be a text that ends with the parameter's unit: "20 s". Throws UserError for another
// unit and for what no parameter can be; whether type and range fit is found out by Module::Set().
ParameterValue ValueFromJson(const nlohmann::json& json, const Parameter& parameter,
                             const std::string& name);

// {"name", "value", "unit", "minimum", "maximum", "doc"}; no limit where there is none.
nlohmann::json ParameterJson(const Module& module, const Parameter& parameter);

}  // namespace runtime
