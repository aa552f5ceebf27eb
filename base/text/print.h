// What a person reads, on its way to a terminal. The names and texts of tasks, files and robots are
// other people's: a terminal obeys the escape sequences in them.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace text {

// `text` with each character that a terminal would obey rather than show in the form `\u001b`, and
// each byte that is not UTF-8 in the form `\xff`. Line ends and tabs stay. The values of JSON stay
// what they are.
std::string Visible(std::string_view text);

// As fmt::print, but so.
template <class... Arguments>
void Print(std::FILE* stream, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::print(stream, "{}", Visible(fmt::format(format, std::forward<Arguments>(arguments)...)));
}
template <class... Arguments>
void Print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  Print(stdout, format, std::forward<Arguments>(arguments)...);
}

}  // namespace text
