// Text in the language of manual pages.
#pragma once

#include <string>
#include <string_view>

namespace command_line {

// Plain text, which shows as it is; what is between backticks is bold instead.
std::string RoffText(std::string_view text);

std::string RoffBold(std::string_view text);
std::string RoffItalic(std::string_view text);

// Lines that stay lines, a little indented: the calls of an example.
std::string RoffLines(std::string_view lines);

}  // namespace command_line
