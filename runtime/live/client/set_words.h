#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace runtime {

// The arguments of `set` from the words of the command line:
//   task.weight 0.5
//   task.limit = 20 s
//   task.weight = 0.1 -> 0.5 over 200 episodes    (the arrow may be written `to` and → as well)
// Throws UserError where they are none of these.
nlohmann::json SetArguments(const std::vector<std::string>& words);

}  // namespace runtime
