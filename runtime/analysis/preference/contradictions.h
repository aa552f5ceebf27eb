#pragma once

#include <vector>

#include "runtime/analysis/preference/preferences_file.h"

namespace runtime {

// Which of the preferences say that something is better than what others call better than it, over
// however many behaviors in between: their indices, ascending. No weights can explain all of them.
std::vector<size_t> FindContradictions(const std::vector<Preference>& preferences);

}  // namespace runtime
