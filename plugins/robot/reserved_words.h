// The words that the task language keeps for itself.
#pragma once

#include <string_view>

namespace robot {

// Whether no task can have a name like that: a keyword or a unit. The compiler's tests hold the
// list to the grammar.
bool IsReservedWord(std::string_view name);

}  // namespace robot
