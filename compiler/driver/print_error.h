// Errors that are not about a place in a task.
#pragma once

#include <string_view>

namespace compiler {

// One line on standard error.
void PrintError(std::string_view message);

}  // namespace compiler
