#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace text {

// How an error message about the unknown `name` continues: ": did you mean `learner`?", or, where
// no candidate looks like it, the list of all: "; there are `learner`, `task`".
std::string Suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace text
