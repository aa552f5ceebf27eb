// Values of parameters as clients write and read them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/core/module/module.h"

namespace runtime {

// Throws UserError, which calls the parameter `name`, for what no parameter can be.
ParameterValue ValueFromJson(const nlohmann::json& json, const std::string& name);

// The numbers of a goal: a number, a flag (0 or 1) or a list. Throws UserError for anything else.
std::vector<double> NumbersIn(const ParameterValue& value, const std::string& name);

// The value as a client means it who knows the parameter: a number may be a text that ends with its
// unit, "20 s", and a whole one be written as 3.0. Throws UserError for another unit; whether type
// and range fit is found out by Module::Set().
ParameterValue FitTo(const Parameter& parameter, ParameterValue value, const std::string& name);

// {"name", "value", "unit", "minimum", "maximum", "doc"}; no limit where there is none.
nlohmann::json ParameterJson(const Module& module, const Parameter& parameter);

}  // namespace runtime
