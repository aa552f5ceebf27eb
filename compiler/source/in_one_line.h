#pragma once

#include <string>
#include <string_view>

namespace compiler {

// Text of a task as written, without comments, and with single spaces for line breaks.
std::string InOneLine(std::string_view source);

}  // namespace compiler
