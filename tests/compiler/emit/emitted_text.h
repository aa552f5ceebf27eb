// What a task's text becomes.
#pragma once

#include <string>

namespace compiler {

// The C++ of a task that must be right; throws std::runtime_error with what is wrong with it.
// `path` is the name that appears in the C++.
std::string EmitText(const std::string& text, const std::string& path = "test.task");

}  // namespace compiler
