// What a learner sees, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "runtime/core/module/observations.h"

namespace runtime {

// A line for each value, which begins with `prefix`: "0 .. 2  base.up  vec3", "3  clock  real [s]".
std::string ToText(const ObservationLayout& layout, const std::string& prefix);

// [{"name", "type", "unit", "first", "size", "least", "greatest"}]: of numbers `first` to `first` +
// `size` - 1; an end that is infinite is null.
nlohmann::ordered_json ToJson(const ObservationLayout& layout);

}  // namespace runtime
