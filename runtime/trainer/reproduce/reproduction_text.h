// What came of training a run again, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "runtime/trainer/reproduce/reproduce_run.h"

namespace runtime {

// Lines, each with its end.
std::string ReproductionText(const Reproduction& found);

// {"run", "is_equal", "episodes", "equal_episodes", "changes", "is_state_equal", "difference":
// {"episode", "values": [{"name", "recorded", "here"}]}, "causes": [{"name", "recorded", "here",
// "is_equal"}], "taken_back"}; what is not known is null.
nlohmann::ordered_json ReproductionJson(const Reproduction& found);

}  // namespace runtime
