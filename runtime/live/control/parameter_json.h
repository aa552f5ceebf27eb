// Goals and parameters as clients write and read them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/core/module/module.h"

namespace runtime {

// The numbers of a goal: a number, a flag (0 or 1) or a list. Throws UserError for anything else.
std::vector<double> NumbersIn(const ParameterValue& value, const std::string& name);

// {"name", "value", "unit", "minimum", "maximum", "doc"}; no limit where there is none.
nlohmann::json ParameterJson(const Module& module, const Parameter& parameter);

}  // namespace runtime
